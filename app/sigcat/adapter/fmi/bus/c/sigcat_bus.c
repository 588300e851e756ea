/*
 * CAN in an FMU, by FMI-LS-BUS 1.0: frames that are received become values of inputs, values of outputs become frames.
 *
 * Operations have an operation code and a length, of four bytes each, and arguments; all numbers are little endian. An operation that
 * is damaged is answered with Format Error. Nothing is allocated: a state has buffers of a fixed size.
 */

#include "sigcat_bus.h"

#include <math.h>
#include <string.h>

#define FORMAT_ERROR 0x01U
#define CAN_TRANSMIT 0x10U
#define CAN_FD_TRANSMIT 0x11U
#define CAN_XL_TRANSMIT 0x12U
#define CONFIRM 0x20U
#define ARBITRATION_LOST 0x30U
#define BUS_ERROR 0x31U
#define CONFIGURATION 0x40U
#define STATUS 0x41U
#define WAKE_UP 0x42U
#define HEADER 8U /* bytes of an operation code and a length */
#define MOST_BYTES 64U /* of a frame */
#define LARGEST_FLOAT 3.4028234663852886e38
#define ROUNDING 1e-14 /* largest relative error of a product and a sum of doubles */

/* The last value of a mapping. */
typedef struct {
    double value; /* received: the last one; sent: the number that waits */
    double sent;
    uint64_t time; /* when its interval began, in ns */
    bool has_time;
    bool has_sent;
    bool is_waiting;
} slot;

typedef struct {
    slot slots[SIGCAT_BUS_MAPPINGS];
    uint64_t bits[SIGCAT_BUS_SIGNALS]; /* of each signal that is sent */
    size_t received_size;
    size_t sent_size;
    bool is_lost; /* whether a frame did not fit */
    unsigned char received[SIGCAT_BUS_BYTES];
    unsigned char sent[SIGCAT_BUS_BYTES];
} bus_state;

typedef struct {
    const unsigned char *data;
    size_t size;
} frame;

/* -- bits -------------------------------------------------------------------------------------------------------- */

/* Bit of a signal among the bits of a frame, from its lowest one on. */
static uint32_t bit_of(const sigcat_signal *signal, uint32_t number)
{
    uint32_t found = signal->start + number;
    if (signal->is_big) {
        found = signal->start + signal->length - 1U - number;
        found = (found / 8U * 8U) + 7U - (found % 8U);
    }
    return found;
}

static uint64_t bits_in(const sigcat_signal *signal, const unsigned char *data)
{
    uint64_t found = 0;
    for (uint32_t i = 0; i < signal->length; i++) {
        const uint32_t bit = bit_of(signal, i);
        found |= (uint64_t)((data[bit / 8U] >> (bit % 8U)) & 1U) << i;
    }
    return found;
}

static void put_bits(const sigcat_signal *signal, uint64_t bits, unsigned char *data)
{
    for (uint32_t i = 0; i < signal->length; i++) {
        const uint32_t bit = bit_of(signal, i);
        if (((bits >> i) & 1U) != 0U) {
            data[bit / 8U] |= (unsigned char)(1U << (bit % 8U));
        } else {
            data[bit / 8U] &= (unsigned char)~(1U << (bit % 8U));
        }
    }
}

static double number_of(const sigcat_signal *signal, uint64_t bits)
{
    double found = (double)bits;
    if (signal->encoding == SIGCAT_REAL) {
        if (signal->length == 32U) {
            const uint32_t half = (uint32_t)bits;
            float single;
            (void)memcpy(&single, &half, sizeof(single));
            found = single;
        } else {
            (void)memcpy(&found, &bits, sizeof(found));
        }
    } else if ((signal->encoding == SIGCAT_SIGNED) && ((bits >> (signal->length - 1U)) != 0U)) {
        found -= ldexp(1.0, (int)signal->length);
    }
    return found;
}

static uint64_t bits_of(const sigcat_signal *signal, double number)
{
    uint64_t found = 0;
    if (signal->encoding == SIGCAT_REAL) {
        if (signal->length == 32U) {
            const float single = (float)number;
            uint32_t half;
            (void)memcpy(&half, &single, sizeof(half));
            found = half;
        } else {
            (void)memcpy(&found, &number, sizeof(found));
        }
    } else {
        found = (uint64_t)(int64_t)number & (UINT64_MAX >> (64U - signal->length));
    }
    return found;
}

/* -- numbers and values ------------------------------------------------------------------------------------------ */

/* A number within the limits of a signal; one that rounding brought beyond a limit is the limit. False if it is outside. */
static bool is_within(const sigcat_signal *signal, double *number)
{
    double limit;
    if (*number < signal->minimum) {
        limit = signal->minimum;
    } else if (*number > signal->maximum) {
        limit = signal->maximum;
    } else {
        return true;
    }
    if (fabs(*number - limit) <= (ROUNDING * fmax(fabs(*number), fabs(limit)))) {
        *number = limit;
        return true;
    }
    return fabs(*number - limit) < (signal->step / 2.0);
}

static const sigcat_item *item_of(const sigcat_mapping *mapping, double given)
{
    for (uint32_t i = 0; i < mapping->item_count; i++) {
        if (mapping->items[i].given == given) {
            return &mapping->items[i];
        }
    }
    return NULL;
}

static bool is_allowed(const sigcat_mapping *mapping, double value)
{
    bool found = mapping->allowed_count == 0U;
    for (uint32_t i = 0; i < mapping->allowed_count; i++) {
        found = found || (mapping->allowed[i] == value);
    }
    return found;
}

/* Whole numbers: the least one, and the one after the greatest. */
static const double least[] = {0.0, 0.0, -128.0, 0.0, -32768.0, 0.0, -2147483648.0, 0.0, -9223372036854775808.0, 0.0};
static const double beyond[] = {
    0.0, 0.0, 128.0, 256.0, 32768.0, 65536.0, 2147483648.0, 4294967296.0, 9223372036854775808.0, 18446744073709551616.0};

/* A value as its type has it. False if the type does not hold it. */
static bool fit(sigcat_type type, double *value)
{
    if (type == SIGCAT_BOOLEAN) {
        const bool is_number = !isnan(*value);
        *value = (*value != 0.0) ? 1.0 : 0.0;
        return is_number;
    }
    if (type == SIGCAT_FLOAT32) {
        const bool is_finite = isfinite(*value);
        if (is_finite && (fabs(*value) > LARGEST_FLOAT)) {
            return false;
        }
        *value = (float)*value;
        return true;
    }
    if (type == SIGCAT_FLOAT64) {
        return true;
    }
    *value = rint(*value);
    return (*value >= least[type]) && (*value < beyond[type]);
}

static size_t put_value(sigcat_type type, double value, unsigned char *to)
{
    const float f32 = (type == SIGCAT_FLOAT32) ? (float)value : 0.0F;
    const bool boolean = value != 0.0;
    const int64_t whole = (type == SIGCAT_UINT64) || (type <= SIGCAT_FLOAT64) ? 0 : (int64_t)value;
    const uint64_t natural = (type == SIGCAT_UINT64) ? (uint64_t)value : 0U;
    const int8_t i8 = (int8_t)whole;
    const uint8_t u8 = (uint8_t)whole;
    const int16_t i16 = (int16_t)whole;
    const uint16_t u16 = (uint16_t)whole;
    const int32_t i32 = (int32_t)whole;
    const uint32_t u32 = (uint32_t)whole;
    switch (type) {
        case SIGCAT_FLOAT32: return (size_t)(sigcat_put(to, &f32, sizeof(f32)) - to);
        case SIGCAT_FLOAT64: return (size_t)(sigcat_put(to, &value, sizeof(value)) - to);
        case SIGCAT_INT8: return (size_t)(sigcat_put(to, &i8, sizeof(i8)) - to);
        case SIGCAT_UINT8: return (size_t)(sigcat_put(to, &u8, sizeof(u8)) - to);
        case SIGCAT_INT16: return (size_t)(sigcat_put(to, &i16, sizeof(i16)) - to);
        case SIGCAT_UINT16: return (size_t)(sigcat_put(to, &u16, sizeof(u16)) - to);
        case SIGCAT_INT32: return (size_t)(sigcat_put(to, &i32, sizeof(i32)) - to);
        case SIGCAT_UINT32: return (size_t)(sigcat_put(to, &u32, sizeof(u32)) - to);
        case SIGCAT_INT64: return (size_t)(sigcat_put(to, &whole, sizeof(whole)) - to);
        case SIGCAT_UINT64: return (size_t)(sigcat_put(to, &natural, sizeof(natural)) - to);
        default: return (size_t)(sigcat_put(to, &boolean, sizeof(boolean)) - to);
    }
}

static double value_at(sigcat_type type, const unsigned char *from)
{
    float f32;
    double f64;
    int8_t i8;
    int16_t i16;
    uint16_t u16;
    int32_t i32;
    uint32_t u32;
    int64_t i64;
    uint64_t u64;
    switch (type) {
        case SIGCAT_FLOAT32: (void)memcpy(&f32, from, sizeof(f32)); return f32;
        case SIGCAT_FLOAT64: (void)memcpy(&f64, from, sizeof(f64)); return f64;
        case SIGCAT_INT8: (void)memcpy(&i8, from, sizeof(i8)); return i8;
        case SIGCAT_INT16: (void)memcpy(&i16, from, sizeof(i16)); return i16;
        case SIGCAT_UINT16: (void)memcpy(&u16, from, sizeof(u16)); return u16;
        case SIGCAT_INT32: (void)memcpy(&i32, from, sizeof(i32)); return i32;
        case SIGCAT_UINT32: (void)memcpy(&u32, from, sizeof(u32)); return u32;
        case SIGCAT_INT64: (void)memcpy(&i64, from, sizeof(i64)); return (double)i64;
        case SIGCAT_UINT64: (void)memcpy(&u64, from, sizeof(u64)); return (double)u64;
        default: return from[0];
    }
}

/* -- receiving --------------------------------------------------------------------------------------------------- */

typedef enum { VALUE, OUTSIDE, UNFIT } outcome;

/* The result of a formula; false if it has none. */
static bool computed(const sigcat_mapping *mapping, double *number)
{
    const double x = *number;
    if (mapping->formula == NULL) {
        return true;
    }
    if (mapping->is_rounded && !isfinite(x)) {
        return false;
    }
    *number = mapping->formula(x);
    return isnan(x) ? isnan(*number) : (isinf(x) || isfinite(*number));
}

static outcome value_of(const sigcat_mapping *mapping, double raw, double *value)
{
    const sigcat_signal *const signal = &sigcat_signals[mapping->signal];
    const sigcat_item *const item = item_of(mapping, raw);
    if (item != NULL) {
        *value = item->meant;
        return (item->has_value && fit(mapping->type, value)) ? VALUE : UNFIT;
    }
    *value = ((signal->factor == 1.0) && (signal->offset == 0.0)) ? raw : ((raw * signal->factor) + signal->offset);
    if (!is_within(signal, value)) {
        return OUTSIDE;
    }
    if (mapping->is_listed || !computed(mapping, value) || !fit(mapping->type, value) || !is_allowed(mapping, *value)) {
        return UNFIT;
    }
    return VALUE;
}

static bool is_same(const slot *last, double value)
{
    return last->has_sent && ((last->value == value) || (isnan(last->value) && isnan(value)));
}

/* Whether a value is handed over, by the interval and the changes of its mapping. */
static bool is_due(const sigcat_mapping *mapping, slot *last, outcome found, double value, uint64_t now)
{
    const bool is_time = !last->has_time || ((now - last->time) >= mapping->interval);
    const bool is_taken = is_time && (found == VALUE) && (!mapping->on_change || !is_same(last, value));
    if (is_taken) {
        last->value = value;
        last->has_sent = true;
    }
    if (is_taken || (is_time && mapping->is_attempt && (found != OUTSIDE))) {
        last->time = now;
        last->has_time = true;
    }
    return is_taken;
}

/* Whether a frame is long enough for a signal, and its multiplexers select it. */
static bool is_in(const sigcat_signal *signal, const frame *from)
{
    bool found = signal->size <= from->size;
    for (uint32_t i = 0; found && (i < signal->selector_count); i++) {
        const sigcat_selector *const selector = &signal->selectors[i];
        const sigcat_signal *const multiplexer = &sigcat_signals[selector->signal];
        bool is_selected = false;
        if (multiplexer->size <= from->size) {
            const uint64_t number = bits_in(multiplexer, from->data);
            for (uint32_t k = 0; k < selector->count; k++) {
                is_selected = is_selected || (selector->numbers[k] == number);
            }
        }
        found = is_selected;
    }
    return found;
}

static void decode(bus_state *self, uint32_t message, const frame *from, uint64_t now, const sigcat_bus_host *host)
{
    for (uint32_t i = 0; i < SIGCAT_BUS_MAPPINGS; i++) {
        const sigcat_mapping *const mapping = &sigcat_mappings[i];
        const sigcat_signal *const signal = &sigcat_signals[mapping->signal];
        double value = 0.0;
        if (!mapping->is_sent && (signal->message == message) && is_in(signal, from)) {
            const outcome found = value_of(mapping, number_of(signal, bits_in(signal, from->data)), &value);
            if (is_due(mapping, &self->slots[i], found, value, now)) {
                unsigned char bytes[sizeof(uint64_t)];
                (void)put_value(mapping->type, value, bytes);
                host->take(host->self, mapping->variable, bytes);
            }
        }
    }
}

static uint32_t natural_at(const unsigned char *bytes, size_t count)
{
    uint32_t found = 0;
    for (size_t i = 0; i < count; i++) {
        found |= (uint32_t)bytes[i] << (8U * i);
    }
    return found;
}

static void put_natural(unsigned char *bytes, size_t count, uint32_t number)
{
    for (size_t i = 0; i < count; i++) {
        bytes[i] = (unsigned char)((number >> (8U * i)) & 0xFFU);
    }
}

/* Room for an operation with its header; NULL if there is none. */
static unsigned char *operation(bus_state *self, uint32_t code, size_t size)
{
    unsigned char *const to = &self->sent[self->sent_size];
    if (size > (SIGCAT_BUS_BYTES - self->sent_size)) {
        self->is_lost = true;
        return NULL;
    }
    put_natural(to, 4U, code);
    put_natural(&to[4], 4U, (uint32_t)size);
    self->sent_size += size;
    return to;
}

static void send_format_error(bus_state *self, const unsigned char *bytes, size_t size)
{
    const size_t most = (size > 0xFFFFU) ? 0xFFFFU : size;
    unsigned char *const to = operation(self, FORMAT_ERROR, HEADER + 2U + most);
    if (to != NULL) {
        put_natural(&to[HEADER], 2U, (uint32_t)most);
        (void)memcpy(&to[HEADER + 2U], bytes, most);
    }
}

static void receive_frame(
    bus_state *self, const unsigned char *bytes, const unsigned char *data, size_t size, uint64_t now, const sigcat_bus_host *host)
{
    const uint32_t identifier = natural_at(&bytes[HEADER], 4U);
    const bool is_extended = bytes[HEADER + 4U] != 0U;
    const frame received = {data, size};
    for (uint32_t i = 0; i < SIGCAT_BUS_MESSAGES; i++) {
        if ((sigcat_messages[i].identifier == identifier) && (sigcat_messages[i].is_extended == is_extended)) {
            decode(self, i, &received, now, host);
        }
    }
}

/* Whether an operation has the arguments of a frame: `fixed` bytes, the last two of which are the length of its data. */
static bool is_frame(const unsigned char *bytes, size_t size, size_t fixed, size_t most)
{
    bool found = false;
    if ((size >= fixed) && (bytes[HEADER + 4U] <= 1U)) {
        const uint32_t identifier = natural_at(&bytes[HEADER], 4U);
        const size_t length = natural_at(&bytes[fixed - 2U], 2U);
        found = (length == (size - fixed)) && (length <= most) && (identifier <= ((bytes[HEADER + 4U] == 1U) ? 0x1FFFFFFFU : 0x7FFU));
    }
    return found;
}

/* False if an operation is damaged or unknown. */
static bool receive_operation(bus_state *self, const unsigned char *bytes, size_t size, uint64_t now, const sigcat_bus_host *host)
{
    bool is_valid = false;
    switch (natural_at(bytes, 4U)) {
        case CAN_TRANSMIT:
            is_valid = is_frame(bytes, size, 16U, 8U) && (bytes[13] <= 1U);
            if (is_valid && (bytes[13] == 0U)) { /* a remote frame has no data */
                receive_frame(self, bytes, &bytes[16], size - 16U, now, host);
            }
            break;
        case CAN_FD_TRANSMIT:
            is_valid = is_frame(bytes, size, 17U, MOST_BYTES) && (bytes[13] <= 1U) && (bytes[14] <= 1U);
            if (is_valid) {
                receive_frame(self, bytes, &bytes[17], size - 17U, now, host);
            }
            break;
        case CAN_XL_TRANSMIT: is_valid = is_frame(bytes, size, 22U, 2048U); break;
        case FORMAT_ERROR: is_valid = (size >= 10U) && (natural_at(&bytes[HEADER], 2U) == (size - 10U)); break;
        case CONFIRM: is_valid = size == 12U; break;
        case ARBITRATION_LOST: is_valid = size == 12U; break;
        case BUS_ERROR: is_valid = size == 15U; break;
        case CONFIGURATION: is_valid = size >= 9U; break;
        case STATUS: is_valid = size == 9U; break;
        case WAKE_UP: is_valid = size == HEADER; break;
        default: break;
    }
    return is_valid;
}

static void receive(void *state, uint64_t now, const sigcat_bus_host *host)
{
    bus_state *const self = (bus_state *)state;
    size_t at = 0;
    while (at < self->received_size) {
        const unsigned char *const bytes = &self->received[at];
        const size_t rest = self->received_size - at;
        size_t size = (rest >= HEADER) ? natural_at(&bytes[4], 4U) : 0U;
        if ((size < HEADER) || (size > rest)) { /* the next operation cannot be found */
            size = rest;
            send_format_error(self, bytes, size);
        } else if (!receive_operation(self, bytes, size, now, host)) {
            send_format_error(self, bytes, size);
        }
        at += size;
    }
    self->received_size = 0;
}

/* -- sending ----------------------------------------------------------------------------------------------------- */

/* The number that is transmitted for a value. False if there is none. */
static bool number_for(const sigcat_mapping *mapping, double value, double *number)
{
    const sigcat_signal *const signal = &sigcat_signals[mapping->signal];
    const sigcat_item *const item = item_of(mapping, value);
    if (item != NULL) {
        *number = item->meant;
        return item->has_value;
    }
    if (mapping->is_listed || (mapping->is_rounded && !isfinite(value))) {
        return false;
    }
    *number = (mapping->formula != NULL) ? mapping->formula(value) : value;
    if (((signal->encoding != SIGCAT_REAL) && !isfinite(*number)) || !is_within(signal, number)) {
        return false;
    }
    *number = ((signal->factor == 1.0) && (signal->offset == 0.0)) ? *number : ((*number - signal->offset) / signal->factor);
    if (signal->encoding == SIGCAT_REAL) {
        return (signal->length != 32U) || !isfinite(*number) || (fabs(*number) <= LARGEST_FLOAT);
    }
    *number = rint(*number);
    if (signal->encoding == SIGCAT_SIGNED) {
        return fabs(*number + 0.5) < ldexp(1.0, (int)signal->length - 1);
    }
    return (*number >= 0.0) && (*number < ldexp(1.0, (int)signal->length));
}

static void send_value(void *state, uint32_t output, const unsigned char *bytes)
{
    bus_state *const self = (bus_state *)state;
    for (uint32_t i = 0; i < SIGCAT_BUS_MAPPINGS; i++) {
        const sigcat_mapping *const mapping = &sigcat_mappings[i];
        double number = 0.0;
        if (mapping->is_sent && (mapping->variable == output) && number_for(mapping, value_at(mapping->type, bytes), &number)) {
            self->slots[i].value = number;
            self->slots[i].is_waiting = true;
        }
    }
}

/* Whether the multiplexers of a signal select it in the next frame. */
static bool is_selected(const bus_state *self, const sigcat_signal *signal)
{
    bool found = true;
    for (uint32_t i = 0; i < signal->selector_count; i++) {
        const sigcat_selector *const selector = &signal->selectors[i];
        bool is_known = false;
        for (uint32_t k = 0; k < selector->count; k++) {
            is_known = is_known || (selector->numbers[k] == self->bits[selector->signal]);
        }
        found = found && is_known;
    }
    return found;
}

static void send_frame(bus_state *self, const sigcat_message *message)
{
    const size_t fixed = message->is_fd ? 17U : 16U;
    unsigned char *const to =
        operation(self, message->is_fd ? CAN_FD_TRANSMIT : CAN_TRANSMIT, fixed + message->length);
    if (to != NULL) {
        put_natural(&to[HEADER], 4U, message->identifier);
        to[HEADER + 4U] = message->is_extended ? 1U : 0U;
        (void)memset(&to[HEADER + 5U], 0, fixed - HEADER - 5U + message->length);
        put_natural(&to[fixed - 2U], 2U, message->length);
        for (uint32_t i = 0; i < message->signal_count; i++) {
            const uint32_t number = message->first_signal + i;
            if (is_selected(self, &sigcat_signals[number])) {
                put_bits(&sigcat_signals[number], self->bits[number], &to[fixed]);
            }
        }
    }
}

static bool is_frame_due(const sigcat_mapping *mapping, slot *last, uint64_t now)
{
    if (last->is_waiting && mapping->on_change && last->has_sent && (last->value == last->sent)) {
        last->is_waiting = false;
    }
    return mapping->is_sent && last->is_waiting && (!last->has_time || ((now - last->time) >= mapping->interval));
}

/* Take a number into the next frame. */
static void take_number(bus_state *self, uint32_t index, uint64_t now)
{
    const sigcat_mapping *const mapping = &sigcat_mappings[index];
    const sigcat_signal *const signal = &sigcat_signals[mapping->signal];
    slot *const last = &self->slots[index];
    self->bits[mapping->signal] = bits_of(signal, last->value);
    if (signal->selector_count > 0U) { /* its own multiplexer is the last one */
        const sigcat_selector *const selector = &signal->selectors[signal->selector_count - 1U];
        self->bits[selector->signal] = selector->numbers[0];
    }
    last->sent = last->value;
    last->time = now;
    last->has_time = true;
    last->has_sent = true;
    last->is_waiting = false;
}

/* Send what is due: one frame of each message, of multiplexed ones one of each part. */
static void flush(void *state, uint64_t now)
{
    bus_state *const self = (bus_state *)state;
    for (uint32_t i = 0; i < SIGCAT_BUS_MAPPINGS; i++) {
        if (is_frame_due(&sigcat_mappings[i], &self->slots[i], now)) {
            for (uint32_t k = i; k < SIGCAT_BUS_MAPPINGS; k++) {
                if ((sigcat_mappings[k].part == sigcat_mappings[i].part) && is_frame_due(&sigcat_mappings[k], &self->slots[k], now)) {
                    take_number(self, k, now);
                }
            }
            send_frame(self, &sigcat_messages[sigcat_signals[sigcat_mappings[i].signal].message]);
        }
    }
}

static uint64_t next_time(const void *state)
{
    const bus_state *const self = (const bus_state *)state;
    uint64_t found = UINT64_MAX;
    for (uint32_t i = 0; i < SIGCAT_BUS_MAPPINGS; i++) {
        const slot *const last = &self->slots[i];
        if (sigcat_mappings[i].is_sent && last->is_waiting) {
            const uint64_t time = (last->has_time ? last->time : 0U) + sigcat_mappings[i].interval;
            found = (time < found) ? time : found;
        }
    }
    return found;
}

/* -- operations of the importer ---------------------------------------------------------------------------------- */

static void start(void *state)
{
    bus_state *const self = (bus_state *)state;
    (void)memset(self, 0, sizeof(*self));
    for (uint32_t i = 0; i < SIGCAT_BUS_SIGNALS; i++) {
        self->bits[i] = sigcat_signals[i].initial;
    }
}

static bool set_received(void *state, const unsigned char *bytes, size_t size)
{
    bus_state *const self = (bus_state *)state;
    if (size > SIGCAT_BUS_BYTES) {
        return false;
    }
    if (size > 0U) {
        (void)memcpy(self->received, bytes, size);
    }
    self->received_size = size;
    return true;
}

static const unsigned char *get_sent(const void *state, size_t *size)
{
    const bus_state *const self = (const bus_state *)state;
    *size = self->sent_size;
    return self->sent;
}

static const unsigned char *get_received(const void *state, size_t *size)
{
    const bus_state *const self = (const bus_state *)state;
    *size = self->received_size;
    return self->received;
}

static bool clear_sent(void *state)
{
    bus_state *const self = (bus_state *)state;
    const bool is_whole = !self->is_lost;
    self->sent_size = 0;
    self->is_lost = false;
    return is_whole;
}

const sigcat_bus sigcat_can = {
    sizeof(bus_state), start, set_received, get_received, receive, send_value, flush, next_time, get_sent, clear_sent};
