/* What every driver of a generated core needs: numbers as hexadecimal bits, read and printed. */

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define MOST_PENDING 4096

static char pending_texts[MOST_PENDING][4096];
static int pending_variables[MOST_PENDING];
static int pending_count;
static int pending_result;

/* The next number of a text, as its bytes. */
static void take(const char **text, void *number, size_t size)
{
    uint64_t bits = 0U;
    size_t digit;
    unsigned char bytes[8];

    for (digit = 0U; digit < 2U * size; digit++) {
        const char letter = **text;
        bits = (bits << 4) | (uint64_t)(letter <= '9' ? letter - '0' : letter - 'a' + 10);
        (*text)++;
    }
    memcpy(bytes, &bits, sizeof(bits));
    memcpy(number, bytes, size);
}

/* A number as its bits. */
static void put(const void *number, size_t size)
{
    uint64_t bits = 0U;

    memcpy(&bits, number, size);
    printf("%0*llx", (int)(2U * size), (unsigned long long)bits);
}

/* A number that the code of the function sees: one NaN is as good as another. */
static void put_float(const float *number)
{
    if (*number != *number) {
        printf("nan");
    } else {
        put(number, sizeof(*number));
    }
}

static void put_double(const double *number)
{
    if (*number != *number) {
        printf("nan");
    } else {
        put(number, sizeof(*number));
    }
}

static const char *next_word(void)
{
    const char *word = strtok(NULL, " \n");
    return word ? word : "";
}

static uint64_t next_number(void)
{
    return strtoull(next_word(), NULL, 10);
}
