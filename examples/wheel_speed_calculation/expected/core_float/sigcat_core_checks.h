/*
 * Checks while the source of an adapter is compiled (section 14 of docs/reference/adapter.md): types of the function's
 * own variables agree with what is declared of them.
 *
 * Part of sigcat: the same file for each function.
 */

#ifndef SIGCAT_CORE_CHECKS_H
#define SIGCAT_CORE_CHECKS_H

#include <stddef.h>
#include <stdint.h>

/*
 * The comma makes a value of a bit field, which has a size. Before C11, an array of -1 elements is the error, and
 * its name the message: some libraries have their own assertion there, without a message.
 */
#if defined(__cplusplus)
#define SIGCAT_CHECK(holds, name, message) static_assert(holds, message)
#define SIGCAT_SIZE_OF(variable) sizeof(decltype(variable))
#else
#if defined(__GNUC__) && !defined(__STRICT_ANSI__)
#define SIGCAT_CHECK(holds, name, message) __extension__ _Static_assert(holds, message)
#elif defined(__STDC_VERSION__) && (__STDC_VERSION__ >= 201112L)
#define SIGCAT_CHECK(holds, name, message) _Static_assert(holds, message)
#else
#define SIGCAT_NAMED(name, line) Sigcat_##name##_in_line_##line
#define SIGCAT_IN_LINE(name, line) SIGCAT_NAMED(name, line)
#define SIGCAT_CHECK(holds, name, message) typedef char SIGCAT_IN_LINE(name, __LINE__)[(holds) ? 1 : -1]
#endif
#define SIGCAT_SIZE_OF(variable) sizeof(((void)0, variable))
#endif

/* Kinds of numbers: 1 unsigned, 2 signed, 3 floating, 4 boolean; 0 is any other type, or a language before C11. */
#if defined(__cplusplus)
#include <type_traits>

template <typename T> constexpr int Sigcat_KindOf()
{
    return std::is_same<T, bool>::value ? 4 : std::is_floating_point<T>::value ? 3
        : (!std::is_integral<T>::value || std::is_same<T, char>::value) ? 0 : std::is_signed<T>::value ? 2 : 1;
}
#define SIGCAT_KIND(value) \
    Sigcat_KindOf<std::remove_cv<std::remove_reference<decltype(value)>::type>::type>()
#else
#if defined(__GNUC__) && !defined(__STRICT_ANSI__)
#define SIGCAT_GENERIC __extension__ _Generic
#elif defined(__STDC_VERSION__) && (__STDC_VERSION__ >= 201112L)
#define SIGCAT_GENERIC _Generic
#endif
#if defined(SIGCAT_GENERIC)
#define SIGCAT_KIND(value) SIGCAT_GENERIC((value), \
    _Bool: 4, float: 3, double: 3, long double: 3, \
    signed char: 2, short: 2, int: 2, long: 2, long long: 2, \
    unsigned char: 1, unsigned short: 1, unsigned int: 1, unsigned long: 1, unsigned long long: 1, default: 0)
#else
#define SIGCAT_KIND(value) 0
#endif
#endif

/* A number keeps its value in a type of its kind, and an unsigned one in a signed type that is wider. */
#define SIGCAT_AGREES(from, to, is_wider) \
    ((SIGCAT_KIND(from) == 0) || (SIGCAT_KIND(to) == 0) || \
     (SIGCAT_KIND(from) == SIGCAT_KIND(to)) || \
     ((SIGCAT_KIND(from) == 1) && (SIGCAT_KIND(to) == 2) && (is_wider)))

/* Numbers that an integer of this kind and size holds. A type of unknown kind is only asked for its size. */
#define SIGCAT_ALL(variable) \
    ((SIGCAT_SIZE_OF(variable) > 2U) ? INT64_C(0xFFFFFFFF) \
     : (SIGCAT_SIZE_OF(variable) > 1U) ? INT64_C(0xFFFF) : INT64_C(0xFF))
#define SIGCAT_LEAST(variable) \
    (((SIGCAT_KIND(variable) == 1) || (SIGCAT_KIND(variable) == 4)) \
     ? INT64_C(0) : (-(SIGCAT_ALL(variable) / 2) - 1))
#define SIGCAT_GREATEST(variable) \
    ((SIGCAT_KIND(variable) == 4) ? INT64_C(1) \
     : (SIGCAT_KIND(variable) == 2) ? (SIGCAT_ALL(variable) / 2) : SIGCAT_ALL(variable))

#define SIGCAT_WHOLE(variable) \
    SIGCAT_CHECK(SIGCAT_KIND(variable) != 3, \
        variable_must_be_an_integer, #variable " must be an integer, not a floating-point number")
#define SIGCAT_NUMBERS(variable, least, greatest) \
    SIGCAT_CHECK((SIGCAT_KIND(variable) != 3) && \
        (((least) >= SIGCAT_LEAST(variable)) || ((SIGCAT_SIZE_OF(variable) > 4U) && (SIGCAT_KIND(variable) != 1))) && \
        (((greatest) <= SIGCAT_GREATEST(variable)) || (SIGCAT_SIZE_OF(variable) > 4U)), \
        variable_must_be_an_integer_that_holds_its_numbers, \
        #variable " must be an integer that holds " #least " to " #greatest)
#define SIGCAT_HOLDS(variable, type) \
    SIGCAT_CHECK((SIGCAT_SIZE_OF(variable) >= sizeof(type)) && \
        SIGCAT_AGREES((type)0, variable, SIGCAT_SIZE_OF(variable) > sizeof(type)), \
        variable_must_not_be_narrower_than_declared, #variable " must be " #type)
#define SIGCAT_FITS(variable, type) \
    SIGCAT_CHECK((SIGCAT_SIZE_OF(variable) <= sizeof(type)) && \
        SIGCAT_AGREES(variable, (type)0, SIGCAT_SIZE_OF(variable) < sizeof(type)), \
        variable_must_not_be_wider_than_declared, #variable " must be " #type)
/* A pointer may have the size of the array by chance. */
#if defined(__cplusplus)
#define SIGCAT_IS_ARRAY(variable) std::is_array<std::remove_reference<decltype(variable)>::type>::value
#elif defined(__GNUC__)
#define SIGCAT_IS_ARRAY(variable) \
    (__builtin_types_compatible_p(__typeof__(variable), __typeof__(&(variable)[0])) == 0)
#else
#define SIGCAT_IS_ARRAY(variable) 1
#endif
#define SIGCAT_HAS(variable, count) \
    SIGCAT_CHECK(SIGCAT_IS_ARRAY(variable) && (sizeof(variable) == ((size_t)(count) * sizeof((variable)[0]))), \
        variable_must_have_as_many_elements_as_declared, #variable " must have " #count " elements")
#define SIGCAT_HAS_ROOM(variable, count) \
    SIGCAT_CHECK(SIGCAT_IS_ARRAY(variable) && (sizeof(variable) >= ((size_t)(count) * sizeof((variable)[0]))), \
        variable_must_have_at_least_as_many_elements_as_declared, #variable " must have at least " #count " elements")

#endif /* SIGCAT_CORE_CHECKS_H */
