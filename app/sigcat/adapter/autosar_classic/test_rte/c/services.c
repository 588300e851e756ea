/* Stand-ins for the services that components call: DEM, FiM, WdgM, NvM, the clock. They record their calls. */
#include <errno.h>
#include <inttypes.h>
#include <stdlib.h>
#include <string.h>

#include "Rte.h"
#include "test_rte.h"

#define FAILED 1U
#define EVENTS 1024U
#define PATH 4096U
#define TELLINGS 4096U

/* A call of a service; its texts live as long as the program. */
typedef struct {
    uint64 time;
    const char *service;
    const char *name;
    const char *value;
} telling;

static FILE *sent_file;
static FILE *told_file;
static telling tellings[TELLINGS]; /* that are not written yet: calls are not to wait for a file */
static uint32 telling_count;
static uint32 ignition_cycle = 1U;

static void fail(const char *name)
{
    (void)fprintf(stderr, "test_rte: %s cannot be written: %s\n", name, strerror(errno));
    exit(TEST_RTE_REFUSED);
}

/* Neither is there, or both are. The system gives memory when it is first written to, which is not to happen in a call. */
void TestRte_OpenRecords(const char *sent, const char *told)
{
    (void)memset(tellings, 0, sizeof(tellings));
    sent_file = fopen(sent, "w");
    if (sent_file == NULL) {
        fail(sent);
    }
    told_file = fopen(told, "w");
    if (told_file == NULL) {
        const int reason = errno;
        (void)fclose(sent_file);
        (void)remove(sent);
        errno = reason;
        fail(told);
    }
    (void)setvbuf(sent_file, NULL, _IOLBF, BUFSIZ); /* what was sent before a component crashes is there */
    (void)fputs("time,name,value\n", sent_file);
    (void)fputs("time,service,name,value\n", told_file);
}

static void write_tellings(void)
{
    for (uint32 i = 0U; i < telling_count; i++) {
        const telling *const one = &tellings[i];
        (void)fprintf(told_file, "%" PRIu64 ",%s,%s,%s\n", one->time, one->service, one->name, one->value);
    }
    telling_count = 0U;
}

void TestRte_CloseRecords(void)
{
    write_tellings();
    const boolean is_whole = (ferror(sent_file) == 0 && ferror(told_file) == 0) ? TRUE : FALSE;
    const int closed = fclose(sent_file) | fclose(told_file);
    if (is_whole == FALSE || closed != 0) {
        fail("What was recorded");
    }
}

void TestRte_Sent(const char *name, const TestRte_Shape *shape, const void *value)
{
    (void)fprintf(sent_file, "%" PRIu64 ",%s,", Os_Now(), name);
    TestRte_Write(sent_file, shape, value);
    (void)fputc('\n', sent_file);
}

void TestRte_Told(const char *service, const char *name, const char *value)
{
    if (telling_count == TELLINGS) {
        write_tellings();
    }
    tellings[telling_count] = (telling){Os_Now(), service, name, value};
    telling_count++;
}

/* -- clock and ignition cycle -------------------------------------------------------------------------------------- */

Std_ReturnType TestRte_GetTime(uint64 *time)
{
    *time = Os_Now();
    return E_OK;
}

void TestRte_SetCycle(uint32 cycle)
{
    ignition_cycle = cycle;
}

Std_ReturnType TestRte_GetCycle(uint32 *cycle)
{
    *cycle = ignition_cycle;
    return E_OK;
}

/* -- end-to-end protection ----------------------------------------------------------------------------------------- */

Std_ReturnType TestRte_Checked(uint8 code, Std_TransformerError *error)
{
    error->errorCode = code;
    error->transformerClass = (code != 0U) ? STD_TRANSFORMER_SAFETY : STD_TRANSFORMER_UNSPECIFIED;
    if (code >= TEST_RTE_HARD_ERROR) {
        return RTE_E_HARD_TRANSFORMER_ERROR;
    }
    return (code != 0U) ? RTE_E_SOFT_TRANSFORMER_ERROR : RTE_E_OK;
}

/* -- diagnosis, and what it inhibits ------------------------------------------------------------------------------- */

static struct {
    const char *name;
    boolean has_failed;
} events[EVENTS];

static boolean is_failed(const char *event)
{
    for (uint32 i = 0U; i < EVENTS && events[i].name != NULL; i++) {
        if (strcmp(events[i].name, event) == 0) {
            return events[i].has_failed;
        }
    }
    return FALSE;
}

static boolean is_inhibited(const TestRte_Inhibition *inhibition)
{
    for (uint32 i = 0U; inhibition->events[i] != NULL; i++) {
        if (is_failed(inhibition->events[i]) != FALSE) {
            return TRUE;
        }
    }
    return FALSE;
}

static void set_event(const char *event, boolean has_failed)
{
    for (uint32 i = 0U; i < EVENTS; i++) {
        if (events[i].name == NULL || strcmp(events[i].name, event) == 0) {
            events[i].name = event;
            events[i].has_failed = has_failed;
            return;
        }
    }
}

Std_ReturnType Dem_SetEventStatus(const char *event, uint8 status)
{
    boolean was_inhibited[EVENTS];
    for (uint32 i = 0U; i < TestRte_InhibitionCount && i < EVENTS; i++) {
        was_inhibited[i] = is_inhibited(&TestRte_Inhibitions[i]);
    }
    set_event(event, (status == FAILED) ? TRUE : FALSE);
    TestRte_Told("DEM", event, (status == FAILED) ? "FAILED" : "PASSED");
    for (uint32 i = 0U; i < TestRte_InhibitionCount && i < EVENTS; i++) {
        const boolean is_now = is_inhibited(&TestRte_Inhibitions[i]);
        if (is_now != was_inhibited[i]) {
            TestRte_Told("FiM", TestRte_Inhibitions[i].name, (is_now != FALSE) ? "INHIBITED" : "PERMITTED");
        }
    }
    return E_OK;
}

/* -- supervision --------------------------------------------------------------------------------------------------- */

Std_ReturnType WdgM_CheckpointReached(const char *entity, const char *checkpoint)
{
    TestRte_Told("WdgM", entity, checkpoint);
    return E_OK;
}

/* -- memory -------------------------------------------------------------------------------------------------------- */

static boolean was_read[EVENTS];
static boolean has_changed_[EVENTS];

static uint32 block_of(const char *name)
{
    uint32 i = 0U;
    while (i < TestRte_BlockCount && strcmp(TestRte_Blocks[i].name, name) != 0) {
        i++;
    }
    return i;
}

static FILE *opened(const char *folder, const char *name, const char *how)
{
    char path[PATH];
    (void)snprintf(path, sizeof(path), "%s/%s.nvm", folder, name);
    return fopen(path, how);
}

void NvM_ReadAll(const char *folder)
{
    for (uint32 i = 0U; folder != NULL && i < TestRte_BlockCount; i++) {
        FILE *const file = opened(folder, TestRte_Blocks[i].name, "rb");
        if (file != NULL) {
            was_read[i] = (fread(TestRte_Blocks[i].memory->ram, TestRte_Blocks[i].memory->size, 1U, file) == 1U && fgetc(file) == EOF) ? TRUE : FALSE;
            (void)fclose(file);
            if (was_read[i] == FALSE) {
                (void)memset(TestRte_Blocks[i].memory->ram, 0, TestRte_Blocks[i].memory->size);
                (void)fprintf(stderr, "test_rte: %s/%s.nvm is left out: it must have %u bytes\n",
                    folder, TestRte_Blocks[i].name, TestRte_Blocks[i].memory->size);
            }
        }
    }
}

void NvM_WriteAll(const char *folder)
{
    for (uint32 i = 0U; folder != NULL && i < TestRte_BlockCount; i++) {
        if (has_changed_[i] != FALSE) {
            FILE *const file = opened(folder, TestRte_Blocks[i].name, "wb");
            if (file == NULL || fwrite(TestRte_Blocks[i].memory->ram, TestRte_Blocks[i].memory->size, 1U, file) != 1U || fclose(file) != 0) {
                fail(TestRte_Blocks[i].name);
            }
        }
    }
}

Std_ReturnType NvM_GetErrorStatus(const char *block, uint8 *result)
{
    const uint32 i = block_of(block);
    *result = (uint8)((i < TestRte_BlockCount && was_read[i] != FALSE) ? 0U : 1U); /* NVM_REQ_OK, NVM_REQ_NOT_OK */
    return E_OK;
}

Std_ReturnType NvM_SetRamBlockStatus(const char *block, boolean has_changed)
{
    const uint32 i = block_of(block);
    if (i >= TestRte_BlockCount) {
        return E_NOT_OK;
    }
    has_changed_[i] = has_changed;
    TestRte_Told("NvM", block, (has_changed != FALSE) ? "CHANGED" : "UNCHANGED");
    return E_OK;
}
