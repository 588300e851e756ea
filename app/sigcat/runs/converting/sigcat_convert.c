/*
 * Converts traces to the input of the driver, and its results to CSV and MCAP. Python loads it; what it does not take,
 * such as a cell that is quoted or wrong, it leaves to Python, which gives the same bytes for all that both take.
 *
 * Tables and states are as `layout.py` packs them.
 */

#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#if defined(_WIN32)
#define API __declspec(dllexport)
#else
#define API __attribute__((visibility("default")))
#endif

#define NONE UINT32_MAX

enum { SKIPPED, BOOLEAN, UINT8, INT8, UINT16, INT16, UINT32, INT32, UINT64, INT64, FLOAT, DOUBLE, SECONDS, LEFT };

typedef struct {
    uint32_t kind;
    uint32_t target, target_count;
    uint32_t symbol, symbol_count;
} column;

typedef struct {
    uint32_t at, size; /* of its text */
    int64_t number;
} symbol;

static const double POWERS[] = {1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16,
                                1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
#define LARGEST_POWER 22

static const uint32_t SIZES[] = {0, 1, 1, 1, 2, 2, 4, 4, 8, 8, 4, 8, 8};

/* -- reading numbers ---------------------------------------------------------------------------------------------- */

/* Whether a double is in the middle of two floats, or so near to 0 that floats are not as dense as elsewhere. */
static bool is_doubtful(double value)
{
    uint64_t bits;
    (void)memcpy(&bits, &value, sizeof(bits));
    return (bits & 0x1FFFFFFFU) == 0x10000000U || fabs(value) < 1.1754943508222875e-38;
}

static bool read_real(const char *at, const char *end, uint32_t kind, unsigned char *to)
{
    const char *const begin = at;
    uint64_t digits = 0;
    int count = 0, shift = 0, exponent = 0;
    bool is_negative = false, any = false;
    double value;
    float single;
    char *stopped;

    if (at < end && (*at == '-' || *at == '+')) {
        is_negative = *at++ == '-';
    }
    for (; at < end && *at >= '0' && *at <= '9'; at++) {
        any = true;
        if (count < 18) {
            digits = digits * 10U + (uint64_t)(*at - '0');
            count += digits != 0U;
        } else {
            count = 99;
        }
    }
    if (at < end && *at == '.') {
        for (at++; at < end && *at >= '0' && *at <= '9'; at++) {
            any = true;
            if (count < 18) {
                digits = digits * 10U + (uint64_t)(*at - '0');
                count += digits != 0U;
                shift++;
            } else {
                count = 99;
            }
        }
    }
    if (!any) {
        return false;
    }
    if (at < end && (*at == 'e' || *at == 'E')) {
        bool minus = false;
        int size = 0;
        at++;
        if (at < end && (*at == '-' || *at == '+')) {
            minus = *at++ == '-';
        }
        for (; at < end && *at >= '0' && *at <= '9' && size < 4; at++, size++) {
            exponent = exponent * 10 + (*at - '0');
        }
        if (size == 0) {
            return false;
        }
        exponent = minus ? -exponent : exponent;
    }
    if (at != end) {
        return false;
    }
    exponent -= shift;
    if (count <= 18 && digits < (UINT64_C(1) << 53) && exponent <= LARGEST_POWER && exponent >= -LARGEST_POWER) {
        value = (exponent < 0) ? (double)digits / POWERS[-exponent] : (double)digits * POWERS[exponent];
        value = is_negative ? -value : value;
        if (kind == DOUBLE) {
            (void)memcpy(to, &value, sizeof(value));
            return true;
        }
        single = (float)value;
        if (!is_doubtful(value) || value == 0.0) {
            (void)memcpy(to, &single, sizeof(single));
            return isfinite(single);
        }
    }
    if (kind == DOUBLE) {
        value = strtod(begin, &stopped);
        (void)memcpy(to, &value, sizeof(value));
        return stopped == end && isfinite(value);
    }
    single = strtof(begin, &stopped);
    (void)memcpy(to, &single, sizeof(single));
    return stopped == end && isfinite(single);
}

static bool read_whole(const char *at, const char *end, uint32_t kind, unsigned char *to)
{
    static const int64_t LEAST[] = {0, 0, 0, INT8_MIN, 0, INT16_MIN, 0, INT32_MIN, 0, INT64_MIN};
    static const uint64_t MOST[] = {0,         1,          UINT8_MAX, INT8_MAX,   UINT16_MAX,
                                    INT16_MAX, UINT32_MAX, INT32_MAX, UINT64_MAX, INT64_MAX};
    const bool is_negative = at < end && *at == '-';
    uint64_t value = 0;
    int64_t number;
    if (is_negative) {
        at++;
    }
    if (at == end || end - at > 18) {
        return false;
    }
    for (; at < end; at++) {
        if (*at < '0' || *at > '9') {
            return false;
        }
        value = value * 10U + (uint64_t)(*at - '0');
    }
    number = is_negative ? -(int64_t)value : (int64_t)value;
    if (number < LEAST[kind] || (!is_negative && value > MOST[kind])) {
        return false;
    }
    (void)memcpy(to, &number, SIZES[kind]); /* the low bytes come first: see is_little */
    return true;
}

static bool read_time(const char *at, const char *end, uint64_t *to)
{
    uint64_t whole = 0, part = 0;
    int size = 0;
    for (; at < end && *at >= '0' && *at <= '9' && size < 9; at++, size++) {
        whole = whole * 10U + (uint64_t)(*at - '0');
    }
    if (size == 0) {
        return false;
    }
    if (at < end && *at == '.') {
        size = 0;
        for (at++; at < end && *at >= '0' && *at <= '9' && size < 9; at++, size++) {
            part = part * 10U + (uint64_t)(*at - '0');
        }
        if (size == 0) {
            return false;
        }
        for (; size < 9; size++) {
            part *= 10U;
        }
    }
    *to = whole * UINT64_C(1000000000) + part;
    return at == end;
}

static bool is_word(const char *at, const char *end, const char *word)
{
    return (size_t)(end - at) == strlen(word) && memcmp(at, word, (size_t)(end - at)) == 0;
}

static bool read_symbol(const char *at, const char *end, const column *of, const symbol *symbols, const char *texts,
                        unsigned char *to)
{
    for (uint32_t i = 0; i < of->symbol_count; i++) {
        const symbol *each = &symbols[of->symbol + i];
        if (each->size == (uint32_t)(end - at) && memcmp(&texts[each->at], at, each->size) == 0) {
            (void)memcpy(to, &each->number, SIZES[of->kind]);
            return true;
        }
    }
    return false;
}

static bool read_value(const char *at, const char *end, const column *of, const symbol *symbols, const char *texts,
                       unsigned char *to)
{
    if (of->symbol_count > 0U) {
        return read_symbol(at, end, of, symbols, texts, to);
    }
    switch (of->kind) {
    case BOOLEAN:
        *to = is_word(at, end, "true") || is_word(at, end, "1");
        return *to != 0U || is_word(at, end, "false") || is_word(at, end, "0");
    case FLOAT:
    case DOUBLE:
        return read_real(at, end, of->kind, to);
    case SECONDS: {
        uint64_t time;
        const bool is_time = read_time(at, end, &time);
        (void)memcpy(to, &time, sizeof(time));
        return is_time;
    }
    case LEFT:
        return false;
    default:
        return read_whole(at, end, of->kind, to);
    }
}

/* -- traces ------------------------------------------------------------------------------------------------------- */

/* The range of a column, and its values that are outside; the range of the time has no end. */
typedef struct {
    double least, greatest;
    uint64_t is_outside; /* the value that was read last */
    uint64_t count, line, time;
} range;

typedef struct {
    const column *columns;
    range *ranges;
    const uint32_t *targets;
    const symbol *symbols;
    const char *texts;
    uint64_t column_count;
    uint64_t row_room; /* bytes that a row may take */
    uint64_t time;     /* of the last row */
    uint64_t has_row;  /* whether there was one */
    uint64_t has_time; /* in MCAP: whether the time was put */
    uint64_t lines;    /* that were read */
    uint64_t row_line; /* that of the last row */
    uint64_t first;    /* time of the first row */
    uint64_t written;
    uint64_t is_left; /* whether the next line, or message, is for Python */
} reading;

static double number_in(const unsigned char *value, uint32_t kind)
{
    union {
        uint8_t u8;
        int8_t i8;
        uint16_t u16;
        int16_t i16;
        uint32_t u32;
        int32_t i32;
        uint64_t u64;
        int64_t i64;
        float single;
        double real;
    } held = {.u64 = 0U};
    (void)memcpy(&held, value, SIZES[kind]);
    switch (kind) {
    case UINT8: return held.u8;
    case INT8: return held.i8;
    case UINT16: return held.u16;
    case INT16: return held.i16;
    case UINT32: return held.u32;
    case INT32: return held.i32;
    case UINT64: return (double)held.u64;
    case INT64: return (double)held.i64;
    case FLOAT: return held.single;
    case DOUBLE: return held.real;
    default: return 0.0;
    }
}

/* Whether a value is outside of the range of its column. NaN is. */
static bool is_outside(const range *of, uint32_t kind, const unsigned char *value)
{
    double number;
    if (of->least == -INFINITY && of->greatest == INFINITY) {
        return false;
    }
    number = number_in(value, kind);
    return !(number >= of->least && number <= of->greatest);
}

static void count_outside(range *of, uint64_t line, uint64_t time)
{
    if (of->count++ == 0U) {
        of->line = line;
        of->time = time;
    }
}

static char *put(char *to, const void *from, size_t size)
{
    (void)memcpy(to, from, size);
    return to + size;
}

static char *put_time(char *to, uint64_t time)
{
    const uint32_t none = NONE;
    return put(put(to, &none, sizeof(none)), &time, sizeof(time));
}

static char *put_value(char *to, const reading *state, const column *of, const unsigned char *value)
{
    for (uint32_t i = 0; i < of->target_count; i++) {
        to = put(put(to, &state->targets[of->target + i], sizeof(uint32_t)), value, SIZES[of->kind]);
    }
    return to;
}

/* The end of a line that can be taken: plain text without quotes. */
static const char *end_of_line(const char *at, const char *end, bool *is_plain)
{
    const char *found = memchr(at, '\n', (size_t)(end - at));
    *is_plain = found != NULL;
    for (const char *each = at; found != NULL && each < found; each++) {
        if ((unsigned char)*each >= 0x80U || *each == '"') {
            *is_plain = false;
        }
    }
    return found;
}

static char *read_row(const char *at, const char *end, char *to, reading *state)
{
    uint64_t time = 0;
    bool any_outside = false;
    for (uint64_t i = 0; i < state->column_count; i++) {
        const column *of = &state->columns[i];
        const char *cell = at;
        unsigned char value[8];
        state->ranges[i].is_outside = 0U;
        while (at < end && *at != ',') {
            at++;
        }
        if ((at < end) != (i + 1U < state->column_count)) {
            return NULL;
        }
        if (i == 0U) {
            if (!read_time(cell, at, &time) || time < state->time) {
                return NULL;
            }
            to = put_time(to, time);
        } else if (of->kind != SKIPPED && at > cell) {
            if (!read_value(cell, at, of, state->symbols, state->texts, value)) {
                return NULL;
            }
            to = put_value(to, state, of, value);
            if (is_outside(&state->ranges[i], of->kind, value)) {
                state->ranges[i].is_outside = 1U;
                any_outside = true;
            }
        }
        at++;
    }
    for (uint64_t i = 0; any_outside && i < state->column_count; i++) {
        if (state->ranges[i].is_outside) {
            count_outside(&state->ranges[i], state->lines + 1U, time);
        }
    }
    state->first = state->has_row ? state->first : time;
    state->time = time;
    state->has_row = 1U;
    return to;
}

/* Bytes of whole lines that were taken. */
API uint64_t sigcat_read_csv(reading *state, const char *in, uint64_t size, char *out, uint64_t room)
{
    const char *at = in, *const end = in + size;
    char *to = out;
    state->is_left = 0U;
    while (at < end && (uint64_t)(to - out) + state->row_room <= room) {
        bool is_plain;
        const char *line_end = end_of_line(at, end, &is_plain);
        const char *text_end = line_end;
        char *after;
        if (line_end == NULL) {
            break;
        }
        while (text_end > at && text_end[-1] == '\r') {
            text_end--;
        }
        after = to;
        if (!is_plain || (text_end > at && (after = read_row(at, text_end, to, state)) == NULL)) {
            state->is_left = 1U;
            break;
        }
        state->lines++;
        if (text_end > at) {
            state->row_line = state->lines;
        }
        to = after;
        at = line_end + 1;
    }
    state->written = (uint64_t)(to - out);
    return (uint64_t)(at - in);
}

/* -- messages of MCAP --------------------------------------------------------------------------------------------- */

#define MESSAGE 5U
#define RECORD_HEAD 9U
#define MESSAGE_HEAD 22U

typedef struct {
    uint8_t kind;
    uint64_t size;
    uint16_t channel;
    uint64_t time;
    const char *data;
    uint64_t data_size;
} record;

/* The next record; false if it is cut. */
static bool next_record(const char *at, const char *end, record *to)
{
    const uint64_t left = (uint64_t)(end - at);
    if (left < RECORD_HEAD) {
        return false;
    }
    to->kind = (uint8_t)*at;
    (void)memcpy(&to->size, at + 1, sizeof(to->size));
    if (to->size > left - RECORD_HEAD || (to->kind == MESSAGE && to->size < MESSAGE_HEAD)) {
        return false;
    }
    if (to->kind == MESSAGE) {
        (void)memcpy(&to->channel, at + RECORD_HEAD, sizeof(to->channel));
        (void)memcpy(&to->time, at + RECORD_HEAD + 6, sizeof(to->time));
        to->data = at + RECORD_HEAD + MESSAGE_HEAD;
        to->data_size = to->size - MESSAGE_HEAD;
    }
    return true;
}

/* Whether the messages are in order of time, from `time` on; the last time is put there. */
API uint64_t sigcat_is_ordered(const char *in, uint64_t size, uint64_t *time)
{
    const char *at = in, *const end = in + size;
    record each;
    for (; at < end; at += RECORD_HEAD + each.size) {
        if (!next_record(at, end, &each)) {
            return 0U;
        }
        if (each.kind == MESSAGE) {
            if (each.time < *time) {
                return 0U;
            }
            *time = each.time;
        }
    }
    return 1U;
}

static const char *after_spaces(const char *at, const char *end)
{
    while (at < end && *at == ' ') {
        at++;
    }
    return at;
}

static const char *after_text(const char *at, const char *end, const char *text)
{
    const size_t size = strlen(text);
    return ((size_t)(end - at) >= size && memcmp(at, text, size) == 0) ? after_spaces(at + size, end) : NULL;
}

static bool is_delimiter(char each)
{
    return each == ',' || each == '}' || each == ' ';
}

/* Where a number or a word of JSON ends. */
static const char *end_of_word(const char *at, const char *end)
{
    while (at < end && !is_delimiter(*at)) {
        at++;
    }
    return at;
}

/* Whether an object of JSON has no `value`, as that of a call. */
static bool has_no_value(const char *at, const char *end)
{
    if (end - at < 2 || *at != '{' || end[-1] != '}') {
        return false;
    }
    for (; at + 7 <= end; at++) {
        if (*at == '\\' || memcmp(at, "\"value\"", 7) == 0) {
            return false;
        }
    }
    return true;
}

/* {"value": 1.5} or {"value": 2, "symbol": "ON"}, with or without spaces. */
static bool read_message(const char *at, const char *end, const column *of, const reading *state, unsigned char *to)
{
    const char *word, *word_end;
    if ((at = after_text(at, end, "{")) == NULL || (at = after_text(at, end, "\"value\"")) == NULL
        || (at = after_text(at, end, ":")) == NULL) {
        return false;
    }
    word = at;
    word_end = end_of_word(at, end);
    at = after_spaces(word_end, end);
    if (of->symbol_count > 0U) {
        if ((at = after_text(at, end, ",")) == NULL || (at = after_text(at, end, "\"symbol\"")) == NULL
            || (at = after_text(at, end, ":")) == NULL || at == end || *at != '"') {
            return false;
        }
        word = ++at;
        while (at < end && *at != '"' && *at != '\\') {
            at++;
        }
        word_end = at;
        if (at == end || *at != '"') {
            return false;
        }
        at = after_spaces(at + 1, end);
    }
    if (at + 1 != end || *at != '}' || of->kind == SECONDS) {
        return false;
    }
    if (is_word(word, word_end, "null") && (of->kind == FLOAT || of->kind == DOUBLE)) {
        const double real = NAN;
        const float single = NAN;
        (void)memcpy(to, of->kind == FLOAT ? (const void *)&single : (const void *)&real, SIZES[of->kind]);
        return true;
    }
    return read_value(word, word_end, of, state->symbols, state->texts, to);
}

static char *put_message(char *to, reading *state, const column *of, uint64_t time, const unsigned char *value)
{
    if (!state->has_row || time != state->time) {
        state->first = state->has_row ? state->first : time;
        state->time = time;
        state->has_row = 1U;
        state->has_time = 0U;
    }
    if (of->kind == SKIPPED) {
        return to;
    }
    if (!state->has_time) {
        to = put_time(to, time);
        state->has_time = 1U;
    }
    return put_value(to, state, of, value);
}

/* Bytes of whole records that were taken. `channels` has the column of each channel, or one of these. */
enum { UNKNOWN = -1, IGNORED = -2 };

API uint64_t sigcat_read_mcap(reading *state, const int32_t *channels, const char *in, uint64_t size, char *out, uint64_t room)
{
    const char *at = in, *const end = in + size;
    char *to = out;
    record each;
    state->is_left = 0U;
    while (at < end && (uint64_t)(to - out) + state->row_room <= room && next_record(at, end, &each)) {
        const int32_t place = (each.kind == MESSAGE) ? channels[each.channel] : UNKNOWN;
        if (place != IGNORED) {
            const column *of = (place == UNKNOWN) ? NULL : &state->columns[place];
            const char *const data_end = each.data + each.data_size;
            unsigned char value[8];
            if (of != NULL && of->kind != SKIPPED && has_no_value(each.data, data_end)) {
                of = &state->columns[0];
            }
            if (of == NULL || (of->kind != SKIPPED && !read_message(each.data, data_end, of, state, value))) {
                state->is_left = 1U;
                break;
            }
            if (of->kind != SKIPPED && is_outside(&state->ranges[of - state->columns], of->kind, value)) {
                count_outside(&state->ranges[of - state->columns], 0U, each.time);
            }
            to = put_message(to, state, of, each.time, value);
        }
        at += RECORD_HEAD + each.size;
    }
    state->written = (uint64_t)(to - out);
    return (uint64_t)(at - in);
}

/* -- results ------------------------------------------------------------------------------------------------------ */

#define HEAD 13U

typedef struct {
    uint32_t size;
    uint32_t place; /* of the column, or number of the channel; NONE if it is not written */
    uint32_t step, step_count;
    uint32_t room; /* bytes of its longest text */
} shape;

typedef struct {
    uint32_t kind; /* SKIPPED: a text */
    uint32_t style;
    uint32_t at, size; /* of the text, or the first of its symbols, and their number */
} step;

enum { PLAIN, JSON, NULLS, WORD, NO_STEP = 16 }; /* how a number is written; NO_STEP: the next one is the same number */

typedef struct {
    const shape *exits;
    const shape *entries;
    const uint32_t *calls; /* texts of their names: place and size; place of their channel */
    const step *steps;
    const symbol *symbols;
    const char *texts;
    uint64_t exit_count, entry_count, call_count, column_count;
    uint64_t written;
    uint64_t is_left; /* whether what follows is for Python */
} writing;

typedef struct {
    uint64_t rows;
    uint64_t has_begun, begun, begun_time, has_time;
    unsigned char *last;        /* values that were sent last */
    const uint64_t *last_place; /* by exits */
    unsigned char *has_last;
    uint64_t whole;
} progress;

static uint32_t number_of(const unsigned char *at)
{
    uint32_t number;
    (void)memcpy(&number, at + 1, sizeof(number));
    return number;
}

static uint64_t time_of(const unsigned char *at)
{
    uint64_t time;
    (void)memcpy(&time, at + 5, sizeof(time));
    return time;
}

/* Bytes of a record; 0 if it is none, or none that belongs to a row. */
static uint64_t size_of(const writing *table, const unsigned char *at)
{
    const uint32_t number = number_of(at);
    switch (*at) {
    case 'S': return number < table->exit_count ? HEAD + (uint64_t)table->exits[number].size : 0U;
    case 'R': return number < table->entry_count ? HEAD + (uint64_t)table->entries[number].size : 0U;
    case 'E': return HEAD + sizeof(uint64_t);
    case 'B':
    case 'D': return HEAD;
    default: return 0U;
    }
}

API uint64_t sigcat_scan(const writing *table, const unsigned char *in, uint64_t at, uint64_t size, progress *state)
{
    bool is_within = false;
    state->whole = at;
    while (at + HEAD <= size) {
        const unsigned char *each = &in[at];
        const uint64_t bytes = size_of(table, each);
        const uint32_t number = number_of(each);
        if (bytes == 0U || at + bytes > size) {
            break;
        }
        if (*each == 'E') {
            uint64_t row;
            (void)memcpy(&row, each + HEAD, sizeof(row));
            if (row != state->rows || (number != NONE && number >= table->call_count)) {
                break;
            }
            state->rows++;
            is_within = false;
        } else if (*each == 'S') {
            (void)memcpy(&state->last[state->last_place[number]], each + HEAD, table->exits[number].size);
            state->has_last[number] = 1U;
            is_within = true;
        } else if (*each != 'R') {
            state->has_begun = *each == 'B';
            state->begun = number;
            state->begun_time = time_of(each);
            state->has_time = 1U;
        }
        at += bytes;
        state->whole = is_within ? state->whole : at;
    }
    return at;
}

/* -- writing numbers ---------------------------------------------------------------------------------------------- */

static char *put_unsigned(char *to, uint64_t value)
{
    char digits[20];
    int count = 0;
    do {
        digits[count++] = (char)('0' + value % 10U);
        value /= 10U;
    } while (value > 0U);
    while (count > 0) {
        *to++ = digits[--count];
    }
    return to;
}

static char *put_signed(char *to, int64_t value)
{
    if (value < 0) {
        *to++ = '-';
        return put_unsigned(to, 0U - (uint64_t)value);
    }
    return put_unsigned(to, (uint64_t)value);
}

/* Digits as Python writes them, with a point after so many of them. */
static char *put_digits(char *to, const char *digits, int count, int point)
{
    while (count > 1 && digits[count - 1] == '0') {
        count--;
    }
    if (point <= -4 || point > 16) {
        const int exponent = point - 1;
        *to++ = digits[0];
        if (count > 1) {
            *to++ = '.';
            to = put(to, &digits[1], (size_t)count - 1U);
        }
        *to++ = 'e';
        *to++ = exponent < 0 ? '-' : '+';
        if (abs(exponent) < 10) {
            *to++ = '0';
        }
        return put_unsigned(to, (uint64_t)abs(exponent));
    }
    if (point <= 0) {
        *to++ = '0';
        *to++ = '.';
        for (; point < 0; point++) {
            *to++ = '0';
        }
        return put(to, digits, (size_t)count);
    }
    for (int i = 0; i < point; i++) {
        *to++ = i < count ? digits[i] : '0';
    }
    *to++ = '.';
    if (count <= point) {
        *to++ = '0';
        return to;
    }
    return put(to, &digits[point], (size_t)(count - point));
}

static char *put_scaled(char *to, uint64_t digits, int shift)
{
    char text[24];
    const int count = (int)(put_unsigned(text, digits) - text);
    return put_digits(to, text, count, count - shift);
}

static int exponent_of(double value)
{
    int found = 0;
    while (found < 15 && value >= POWERS[found + 1]) {
        found++;
    }
    if (value < 1.0) {
        for (found = -1; value * POWERS[-found] < 1.0; found--) {
        }
    }
    return found;
}

/* With `digits` digits that the C library rounds. */
static char *put_rounded(char *to, double value, int digits)
{
    char text[48], all[24];
    int count = 0;
    (void)snprintf(text, sizeof(text), "%.*e", digits - 1, value);
    for (const char *each = text; *each != 'e'; each++) {
        if (*each != '.') {
            all[count++] = *each;
        }
    }
    return put_digits(to, all, count, atoi(strchr(text, 'e') + 1) + 1);
}

/* The fewest digits, 6 at least, that give the same float again; as `_float_text` in cells.py. */
static char *put_float(char *to, float value)
{
    const double wide = (double)value;
    if (wide >= 1e-3 && wide < 1e6) { /* the product is exact: 24 bits and those of 5^12 */
        const int exponent = exponent_of(wide);
        for (int digits = 6; digits < 10; digits++) {
            const int shift = digits - 1 - exponent;
            const double scaled = (shift <= 12) ? rint(wide * POWERS[shift]) : 0.0;
            const double near = scaled / POWERS[shift];
            if (shift <= 12 && !is_doubtful(near) && (float)near == value) {
                return put_scaled(to, (uint64_t)scaled, shift);
            }
        }
    }
    for (int digits = fabs(wide) >= 1.1754943508222875e-38 ? 6 : 1; digits < 9; digits++) {
        char text[32];
        (void)snprintf(text, sizeof(text), "%.*e", digits - 1, wide);
        if (strtof(text, NULL) == value) {
            return put_rounded(to, wide, digits);
        }
    }
    return put_rounded(to, wide, 9);
}

/* As Python writes it; NULL if that is for Python: next to powers of two and to 0, the nearest digits are others. */
static char *put_double(char *to, double value)
{
    uint64_t bits;
    char text[32];
    if (value >= 1e-3 && value < 1e15) {
        const int shift = 14 - exponent_of(value);
        const double scaled = rint(value * POWERS[shift]);
        if (scaled < 9007199254740992.0 && scaled / POWERS[shift] == value) {
            return put_scaled(to, (uint64_t)scaled, shift);
        }
    }
    (void)memcpy(&bits, &value, sizeof(bits));
    if ((bits & UINT64_C(0xFFFFFFFFFFFFF)) == 0U || value < 2.2250738585072014e-308) {
        return NULL;
    }
    for (int digits = 15; digits < 17; digits++) {
        (void)snprintf(text, sizeof(text), "%.*e", digits - 1, value);
        if (strtod(text, NULL) == value) {
            return put_rounded(to, value, digits);
        }
    }
    return put_rounded(to, value, 17);
}

static char *put_text(char *to, const char *text)
{
    return put(to, text, strlen(text));
}

static char *put_real(char *to, double value, bool is_float, uint32_t style)
{
    if (!isfinite(value)) {
        if (style == NULLS) {
            return put_text(to, "null");
        }
        if (isnan(value)) {
            return put_text(to, style == JSON ? "NaN" : "nan");
        }
        return put_text(value < 0.0 ? put_text(to, "-") : to, style == JSON ? "Infinity" : "inf");
    }
    if (signbit(value)) {
        *to++ = '-';
        value = -value;
    }
    if (value == 0.0) {
        return put_text(to, "0.0");
    }
    return is_float ? put_float(to, (float)value) : put_double(to, value);
}

static int64_t whole_of(const unsigned char *at, uint32_t kind)
{
    switch (kind) {
    case UINT8: return *at;
    case INT8: return (int8_t)*at;
    case UINT16: { uint16_t found; (void)memcpy(&found, at, sizeof(found)); return found; }
    case INT16: { int16_t found; (void)memcpy(&found, at, sizeof(found)); return found; }
    case UINT32: { uint32_t found; (void)memcpy(&found, at, sizeof(found)); return found; }
    case INT32: { int32_t found; (void)memcpy(&found, at, sizeof(found)); return found; }
    default: { int64_t found; (void)memcpy(&found, at, sizeof(found)); return found; }
    }
}

static const symbol *symbol_of(const writing *table, const step *of, int64_t number)
{
    for (uint32_t i = 0; i < of->size; i++) {
        if (table->symbols[of->at + i].number == number) {
            return &table->symbols[of->at + i];
        }
    }
    return NULL;
}

static char *put_whole(char *to, const writing *table, const step *of, const unsigned char *at, uint32_t style)
{
    const int64_t number = whole_of(at, of->kind);
    const symbol *found = (of->size > 0U && style != NULLS) ? symbol_of(table, of, number) : NULL;
    if (found != NULL) {
        const char *quote = (style == JSON) ? "\"\"" : (style == WORD) ? "\"" : "";
        to = put_text(to, quote);
        to = put(to, &table->texts[found->at], found->size);
        return put_text(to, quote);
    }
    if (style == WORD) {
        return put_text(to, "null");
    }
    return (of->kind == UINT64) ? put_unsigned(to, (uint64_t)number) : put_signed(to, number);
}

static char *put_number(char *to, const writing *table, const step *of, const unsigned char *at)
{
    const uint32_t style = of->style & ~(uint32_t)NO_STEP;
    if (of->kind == FLOAT) {
        float value;
        (void)memcpy(&value, at, sizeof(value));
        return put_real(to, (double)value, true, style);
    }
    if (of->kind == DOUBLE) {
        double value;
        (void)memcpy(&value, at, sizeof(value));
        return put_real(to, value, false, style);
    }
    return (of->kind == BOOLEAN) ? put_text(to, *at ? "true" : "false") : put_whole(to, table, of, at, style);
}

/* The text of a value; NULL if it is for Python. */
static char *put_shape(char *to, const writing *table, const shape *of, const unsigned char *at)
{
    for (uint32_t i = 0; i < of->step_count && to != NULL; i++) {
        const step *each = &table->steps[of->step + i];
        if (each->kind == SKIPPED) {
            to = put(to, &table->texts[each->at], each->size);
        } else {
            to = put_number(to, table, each, at);
            at += (each->style & NO_STEP) ? 0U : SIZES[each->kind];
        }
    }
    return to;
}

/* -- CSV ---------------------------------------------------------------------------------------------------------- */

#define VALUES 4096U

typedef struct {
    const unsigned char *values[VALUES]; /* records, by their order */
    uint32_t count;
    const unsigned char *end; /* its last record */
    uint64_t room;
} row;

/* The next row of a block; other values are left out. False if there is none, or it has too many values. */
static bool next_row(const writing *table, const unsigned char *at, const unsigned char *end, row *to)
{
    to->count = 0;
    to->room = 0;
    for (; at < end; at += size_of(table, at)) {
        if (*at == 'E') {
            to->end = at;
            to->room += ((uint64_t)to->count + 1U) * (table->column_count + 512U);
            return true;
        }
        if (*at == 'S') {
            if (to->count == VALUES) {
                return false;
            }
            to->room += table->exits[number_of(at)].room;
            to->values[to->count++] = at;
        }
    }
    return false;
}

static char *put_head(char *to, const writing *table, uint64_t time, uint32_t call)
{
    char digits[9];
    uint64_t part = time % UINT64_C(1000000000);
    to = put_unsigned(to, time / UINT64_C(1000000000));
    *to++ = '.';
    for (int i = 8; i >= 0; i--) {
        digits[i] = (char)('0' + part % 10U);
        part /= 10U;
    }
    to = put(to, digits, sizeof(digits));
    *to++ = ',';
    return (call == NONE) ? to : put(to, &table->texts[table->calls[call * 3U]], table->calls[call * 3U + 1U]);
}

static char *put_cells(char *to, const writing *table, const unsigned char **by_column)
{
    for (uint64_t i = 0; i < table->column_count && to != NULL; i++) {
        const unsigned char *value = by_column[i];
        *to++ = ',';
        if (value != NULL) {
            to = put_shape(to, table, &table->exits[number_of(value)], value + HEAD);
        }
    }
    if (to != NULL) {
        *to++ = '\n';
    }
    return to;
}

/* Of several values of a column, each but the last has a row before that of the call. */
static char *put_row(char *to, const writing *table, const row *of, const unsigned char **by_column)
{
    for (uint32_t i = 0; i < of->count; i++) {
        by_column[table->exits[number_of(of->values[i])].place] = of->values[i];
    }
    for (uint32_t i = 0; i < of->count && to != NULL; i++) {
        const uint32_t place = table->exits[number_of(of->values[i])].place;
        if (by_column[place] != of->values[i]) {
            to = put_head(to, table, time_of(of->end), NONE);
            for (uint64_t k = 0; k < table->column_count && to != NULL; k++) {
                *to++ = ',';
                if (k == place) {
                    to = put_shape(to, table, &table->exits[number_of(of->values[i])], of->values[i] + HEAD);
                }
            }
            if (to != NULL) {
                *to++ = '\n';
            }
        }
    }
    to = (to == NULL) ? NULL : put_cells(put_head(to, table, time_of(of->end), number_of(of->end)), table, by_column);
    for (uint32_t i = 0; i < of->count; i++) {
        by_column[table->exits[number_of(of->values[i])].place] = NULL;
    }
    return to;
}

/* Bytes of whole rows that were written; `by_column` has room for the columns, and holds NULL. */
API uint64_t sigcat_write_csv(writing *table, const unsigned char *in, uint64_t size, char *out, uint64_t room,
                              const unsigned char **by_column)
{
    const unsigned char *at = in, *const end = in + size;
    char *to = out;
    static row each;
    table->is_left = 0U;
    while (at < end) {
        char *after;
        if (!next_row(table, at, end, &each)) {
            table->is_left = each.count == VALUES;
            at = table->is_left ? at : end;
            break;
        }
        if ((uint64_t)(to - out) + each.room > room) {
            table->is_left = to == out;
            break;
        }
        after = put_row(to, table, &each, by_column);
        if (after == NULL) {
            table->is_left = 1U;
            break;
        }
        to = after;
        at = each.end + HEAD + sizeof(uint64_t);
    }
    table->written = (uint64_t)(to - out);
    return (uint64_t)(at - in);
}

/* -- MCAP --------------------------------------------------------------------------------------------------------- */

static char *begin_message(char *to, uint32_t channel, uint64_t time)
{
    const uint16_t number = (uint16_t)channel;
    const uint32_t sequence = 0;
    *to++ = (char)MESSAGE;
    to = put(to + sizeof(uint64_t), &number, sizeof(number));
    to = put(to, &sequence, sizeof(sequence));
    to = put(to, &time, sizeof(time));
    return put(to, &time, sizeof(time));
}

static void end_message(char *begin, const char *end)
{
    const uint64_t size = (uint64_t)(end - begin) - RECORD_HEAD;
    (void)memcpy(begin + 1, &size, sizeof(size));
}

static char *put_call(char *to, uint64_t time)
{
    if (time >= (UINT64_C(1) << 53)) {
        return NULL;
    }
    to = put_real(put_text(to, "{\"time\":"), (double)time / 1e9, false, NULLS);
    return (to == NULL) ? NULL : put_text(to, "}");
}

/* Bytes of whole records that were written as messages. */
API uint64_t sigcat_write_mcap(writing *table, const unsigned char *in, uint64_t size, char *out, uint64_t room)
{
    const unsigned char *at = in, *const end = in + size;
    char *to = out;
    table->is_left = 0U;
    for (; at < end; at += size_of(table, at)) {
        const uint32_t number = number_of(at);
        const shape *of = (*at == 'S') ? &table->exits[number] : (*at == 'R') ? &table->entries[number] : NULL;
        const uint32_t channel = (of != NULL) ? of->place : (*at == 'E' && number != NONE) ? table->calls[number * 3U + 2U] : NONE;
        char *after;
        if (channel == NONE) {
            continue;
        }
        if ((uint64_t)(to - out) + 128U + ((of != NULL) ? of->room : 0U) > room) {
            table->is_left = to == out;
            break;
        }
        after = begin_message(to, channel, time_of(at));
        after = (of != NULL) ? put_shape(after, table, of, at + HEAD) : put_call(after, time_of(at));
        if (after == NULL) {
            table->is_left = 1U;
            break;
        }
        end_message(to, after);
        to = after;
    }
    table->written = (uint64_t)(to - out);
    return (uint64_t)(at - in);
}

/* Times and places of messages, by channel; `counts` has how many of each there are. Bytes that were written. */
API uint64_t sigcat_index_mcap(const char *in, uint64_t size, char *out, uint32_t *counts)
{
    static uint64_t places[65536];
    const char *at, *const end = in + size;
    uint64_t total = 0;
    record each = {0};
    (void)memset(counts, 0, 65536U * sizeof(*counts));
    for (at = in; at < end && next_record(at, end, &each); at += RECORD_HEAD + each.size) {
        counts[each.channel]++;
    }
    for (uint32_t i = 0; i < 65536U; i++) {
        places[i] = total;
        total += 16U * (uint64_t)counts[i];
    }
    for (at = in; at < end && next_record(at, end, &each); at += RECORD_HEAD + each.size) {
        const uint64_t place = (uint64_t)(at - in);
        char *to = out + places[each.channel];
        places[each.channel] += 16U;
        (void)put(put(to, &each.time, sizeof(each.time)), &place, sizeof(place));
    }
    return total;
}

API uint64_t sigcat_is_little(void)
{
    const uint16_t one = 1U;
    return *(const unsigned char *)&one;
}
