/*
 * The functions of FMI 3.0 for co-simulation and scheduled execution, over the cores of functions.
 *
 * A step from t to t + h hands over the inputs that were set, as received at t, and runs every call that is due at t or
 * later, and before t + h, at its own time. A call that is due at t + h runs in the next step, after the inputs of that time.
 *
 * With event mode, inputs that are set in it are received at that time, and the calls that are due run in it.
 *
 * A bus is used in event mode: what it has sent in a step is in Tx_Data at its end, and what it has received is handed over by
 * fmi3UpdateDiscreteStates. Tx_Data has the operations of one iteration of an event.
 *
 * In scheduled execution, the importer activates each call by its clock. Other calls that are due wait for their clocks. Everything
 * but the code of a call is locked against preemption.
 */

#include "sigcat_fmi3.h"
#include "sigcat_fmu.h"

#include <stdlib.h>
#include <string.h>

#define ROUNDS 100000U /* of calls at one time; after so many, they trigger each other without end */
#define NANOSECONDS 1e9
#define OUT_OF_RANGE "A parameter is out of its range; none of its function has changed."
#define ENDLESS "Calls trigger each other without end."
#define LOST "The bus has sent more than Tx_Data holds, and frames are lost. Use shorter steps."
#define LONGEST 9e6 /* s: a double holds every nanosecond of it */

static const size_t sizes[] = {4U, 8U, 1U, 1U, 2U, 2U, 4U, 4U, 8U, 8U, 1U}; /* by sigcat_type */

typedef enum { INSTANTIATED, INITIALIZATION, EVENT, STEP, ACTIVATION, TERMINATED } phase;

/* How an importer uses an instance. */
typedef enum { WITHOUT_EVENTS, WITH_EVENTS, SCHEDULED } usage;

static const phase after_initialization[] = {STEP, EVENT, ACTIVATION}; /* by usage */

/* What is saved with the state of an instance, besides values and cores. */
typedef struct {
    uint64_t now; /* since the start, in ns */
    double start; /* in s */
    phase phase;
    usage usage;
    bool is_received; /* whether the clock of what the bus receives is active */
    bool is_announced; /* whether the importer knows that the bus has sent */
} progress;

typedef struct {
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
    bool is_logging;
    fmi3LockPreemptionCallback lock; /* NULL without preemption, as the other one */
    fmi3UnlockPreemptionCallback unlock;
    sigcat_host host;
    progress at;
    unsigned char *values;
    bool *is_set; /* of each input: whether it was set since the last step */
    bool *has_parameters; /* of each function: whether one was set since the last step */
    bool *is_waiting; /* of each call: whether it is due, and its clock was not activated yet */
    void **states;
    void *bus; /* state of the bus; NULL without one */
} component;

static bool is_instantiated; /* where a process has one instance */

/* -- messages ---------------------------------------------------------------------------------------------------- */

static fmi3Status told(const component *self, fmi3Status status, const char *message)
{
    if ((self != NULL) && (self->log != NULL) && (self->is_logging || (status >= fmi3Error))) {
        self->log(self->environment, status, (status >= fmi3Error) ? "logStatusError" : "logStatusWarning", message);
    }
    return status;
}

static fmi3Status not_offered(fmi3Instance instance)
{
    return told((const component *)instance, fmi3Error, "This FMU does not offer the function that was called.");
}

/* NULL, with a message, in another phase. */
static component *in_phase(fmi3Instance instance, phase wanted, const char *message)
{
    component *const self = (component *)instance;
    if ((self != NULL) && (self->at.phase == wanted)) {
        return self;
    }
    (void)told(self, fmi3Error, message);
    return NULL;
}

/* -- what functions exchange ------------------------------------------------------------------------------------- */

/* A bus needs its clocks. */
static bool has_bus(const component *self)
{
    return (sigcat_model.bus != NULL) && (self->at.usage == WITH_EVENTS);
}

static void sends(void *given, uint32_t number, const unsigned char *bytes)
{
    component *const self = (component *)given;
    const sigcat_output *const sent = &sigcat_model.outputs[number];
    (void)memcpy(&self->values[sent->offset], bytes, sent->size);
    if (has_bus(self)) {
        sigcat_model.bus->send_value(self->bus, number, bytes);
    }
    for (uint32_t i = 0; i < sent->count; i++) {
        const sigcat_input *const input = &sigcat_model.inputs[sent->inputs[i]];
        sigcat_model.functions[input->function]->receive(self->states[input->function], input->receiver, bytes, self->at.now);
    }
}

static void stores(void *self, uint32_t number, const unsigned char *bytes, size_t size)
{
    (void)self;
    (void)number;
    (void)bytes;
    (void)size;
}

static bool is_there(void *self, uint32_t function)
{
    (void)self;
    (void)function;
    return true;
}

static bool serves(void *given, uint32_t function, uint32_t method, const unsigned char *arguments, unsigned char *results)
{
    component *const self = (component *)given;
    return sigcat_model.functions[function]->serve(self->states[function], method, arguments, results);
}

static void receive_inputs(component *self)
{
    for (uint32_t i = 0; i < sigcat_model.input_count; i++) {
        const sigcat_input *const input = &sigcat_model.inputs[i];
        if (self->is_set[input->variable]) {
            sigcat_model.functions[input->function]->receive(
                self->states[input->function], input->receiver, &self->values[input->offset], self->at.now);
        }
    }
    (void)memset(self->is_set, 0, sigcat_model.input_count * sizeof(bool));
}

/* An input has come over the bus. */
static void take(void *given, uint32_t variable, const unsigned char *bytes)
{
    component *const self = (component *)given;
    const sigcat_variable *const input = &sigcat_model.variables[variable];
    (void)memcpy(&self->values[input->offset], bytes, sizes[input->type]);
    self->is_set[input->owner] = true;
}

static void receive_bus(component *self)
{
    const sigcat_bus_host host = {self, take};
    if (self->at.is_received) {
        sigcat_model.bus->receive(self->bus, self->at.now, &host);
        self->at.is_received = false;
    }
}

static bool has_sent(const component *self)
{
    size_t size = 0;
    if (has_bus(self)) {
        (void)sigcat_model.bus->get_sent(self->bus, &size);
    }
    return size > 0U;
}

static bool take_parameters(component *self)
{
    bool is_taken = true;
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        if (self->has_parameters[i]) {
            unsigned char *const bytes = &self->values[sigcat_model.parameters[i]];
            self->has_parameters[i] = false;
            if (!sigcat_model.functions[i]->set_parameters(self->states[i], bytes)) {
                sigcat_model.functions[i]->get_parameters(self->states[i], bytes);
                is_taken = false;
            }
        }
    }
    return is_taken;
}

/* -- calls ------------------------------------------------------------------------------------------------------- */

static void lock(const component *self)
{
    if (self->lock != NULL) {
        self->lock();
    }
}

static void unlock(const component *self)
{
    if (self->unlock != NULL) {
        self->unlock();
    }
}

static void run_call(component *self, uint32_t number, uint32_t call)
{
    const sigcat_function *const function = sigcat_model.functions[number];
    void *const state = self->states[number];
    function->set_input(state, call, self->at.now);
    function->begin(state, call, self->at.now);
    function->send(state, &self->host);
    unlock(self);
    function->run(state, call);
    lock(self);
    function->get_output(state, call, self->at.now);
    function->send(state, &self->host);
}

/* Functions take turns, in the order of the set, as in a simulation. */
static bool run_calls_once(component *self)
{
    bool any = false;
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        const uint32_t call = sigcat_model.functions[i]->next_call(self->states[i], self->at.now);
        if (call != SIGCAT_NONE) {
            run_call(self, i, call);
            any = true;
        }
    }
    return any;
}

static void supervise(component *self)
{
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        sigcat_model.functions[i]->supervise(self->states[i], self->at.now);
        sigcat_model.functions[i]->send(self->states[i], &self->host);
    }
}

static bool run_calls(component *self)
{
    uint32_t rounds = 0;
    while ((rounds < ROUNDS) && run_calls_once(self)) {
        rounds++;
    }
    supervise(self);
    if (has_bus(self)) {
        sigcat_model.bus->flush(self->bus, self->at.now);
    }
    return rounds < ROUNDS;
}

/* The call that was activated, or one that the function itself triggers; those of other clocks wait until these are activated. */
static uint32_t next_of(component *self, uint32_t activated)
{
    uint32_t call = SIGCAT_NONE;
    if (self->is_waiting[activated]) {
        self->is_waiting[activated] = false;
        return activated;
    }
    do {
        call = sigcat_model.functions[0]->next_call(self->states[0], self->at.now);
        if ((call == SIGCAT_NONE) || (call == activated) || sigcat_model.calls[call].is_inside) {
            return call;
        }
        self->is_waiting[call] = true;
    } while (true);
}

static bool run_activated(component *self, uint32_t activated)
{
    uint32_t rounds = 0;
    uint32_t call = next_of(self, activated);
    while ((rounds < ROUNDS) && (call != SIGCAT_NONE)) {
        run_call(self, 0U, call);
        call = next_of(self, activated);
        rounds++;
    }
    supervise(self);
    return rounds < ROUNDS;
}

/* Whether a call, a window of supervision or a frame is due now. */
static bool is_due(const component *self)
{
    bool found = has_bus(self) && (sigcat_model.bus->next_time(self->bus) <= self->at.now);
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        found = found || (sigcat_model.functions[i]->next_time(self->states[i]) <= self->at.now);
    }
    return found;
}

static uint64_t next_time(const component *self, uint64_t end)
{
    uint64_t found = end;
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        const uint64_t time = sigcat_model.functions[i]->next_time(self->states[i]);
        if ((time > self->at.now) && (time < found)) {
            found = time;
        }
    }
    if (has_bus(self)) {
        const uint64_t time = sigcat_model.bus->next_time(self->bus);
        found = ((time > self->at.now) && (time < found)) ? time : found;
    }
    return found;
}

static bool run_until(component *self, uint64_t end)
{
    bool is_done = true;
    while (is_done && (self->at.now < end)) {
        is_done = run_calls(self);
        self->at.now = next_time(self, end);
    }
    return is_done;
}

/* -- life -------------------------------------------------------------------------------------------------------- */

static void destroy_states(component *self)
{
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        if (self->states[i] != NULL) {
            sigcat_model.functions[i]->destroy(self->states[i]);
            self->states[i] = NULL;
        }
    }
}

static bool create_states(component *self)
{
    bool is_whole = true;
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        self->states[i] = sigcat_model.functions[i]->create();
        is_whole = is_whole && (self->states[i] != NULL);
    }
    return is_whole;
}

static void begin_again(component *self, usage wanted)
{
    const progress beginning = {0U, 0.0, INSTANTIATED, wanted, false, false};
    self->at = beginning;
    (void)memcpy(self->values, sigcat_model.values, sigcat_model.value_count);
    (void)memset(self->is_set, 0, sigcat_model.input_count * sizeof(bool));
    (void)memset(self->has_parameters, 0, sigcat_model.function_count * sizeof(bool));
    (void)memset(self->is_waiting, 0, sigcat_model.call_count * sizeof(bool));
    if (self->bus != NULL) {
        sigcat_model.bus->start(self->bus);
    }
}

static void free_component(component *self)
{
    if (self->states != NULL) {
        destroy_states(self);
    }
    free(self->values);
    free(self->is_set);
    free(self->has_parameters);
    free(self->is_waiting);
    free(self->states);
    free(self->bus);
    free(self);
}

static component *new_component(void)
{
    component *self = (component *)calloc(1U, sizeof(component));
    if (self != NULL) {
        const sigcat_host host = {self, sends, stores, is_there, serves};
        self->host = host;
        self->values = (unsigned char *)malloc((size_t)sigcat_model.value_count + 1U);
        self->is_set = (bool *)calloc((size_t)sigcat_model.input_count + 1U, sizeof(bool));
        self->has_parameters = (bool *)calloc((size_t)sigcat_model.function_count + 1U, sizeof(bool));
        self->is_waiting = (bool *)calloc((size_t)sigcat_model.call_count + 1U, sizeof(bool));
        self->states = (void **)calloc((size_t)sigcat_model.function_count + 1U, sizeof(void *));
        self->bus = (sigcat_model.bus != NULL) ? malloc(sigcat_model.bus->state_size) : NULL;
        if ((self->values == NULL) || (self->is_set == NULL) || (self->has_parameters == NULL) || (self->is_waiting == NULL)
            || (self->states == NULL) || ((self->bus == NULL) && (sigcat_model.bus != NULL)) || !create_states(self)) {
            free_component(self);
            self = NULL;
        }
    }
    return self;
}

SIGCAT_EXPORT const char *FMI3(GetVersion)(void)
{
    return "3.0";
}

SIGCAT_EXPORT fmi3Status FMI3(SetDebugLogging)(fmi3Instance instance, fmi3Boolean loggingOn, size_t nCategories, const fmi3String categories[])
{
    component *const self = (component *)instance;
    (void)nCategories;
    (void)categories;
    if (self == NULL) {
        return fmi3Error;
    }
    self->is_logging = loggingOn;
    return fmi3OK;
}

static fmi3Instance refused(fmi3LogMessageCallback log, fmi3InstanceEnvironment environment, const char *message)
{
    if (log != NULL) {
        log(environment, fmi3Error, "logStatusError", message);
    }
    return NULL;
}

static component *instantiated(
    fmi3String name, fmi3String token, fmi3Boolean is_logging, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log,
    usage wanted)
{
    component *self;
    if ((name == NULL) || (name[0] == '\0')) {
        return refused(log, environment, "The instance must have a name.");
    }
    if ((token == NULL) || (strcmp(token, sigcat_model.token) != 0)) {
        return refused(log, environment, "The instantiation token must be that of modelDescription.xml.");
    }
    if (sigcat_model.is_scheduled != (wanted == SCHEDULED)) {
        return refused(
            log, environment, sigcat_model.is_scheduled ? "This FMU is for scheduled execution." : "This FMU is for co-simulation.");
    }
    if (sigcat_model.is_single && is_instantiated) {
        return refused(log, environment, "The code has global variables: a process can have one instance.");
    }
    self = new_component();
    if (self == NULL) {
        return refused(log, environment, "No memory is left.");
    }
    self->environment = environment;
    self->log = log;
    self->is_logging = is_logging;
    begin_again(self, wanted);
    is_instantiated = true;
    if ((sigcat_model.bus != NULL) && (wanted != WITH_EVENTS)) {
        (void)told(self, fmi3Warning, "Without event mode, nothing is sent to the bus, and nothing is received from it.");
    }
    return self;
}

SIGCAT_EXPORT fmi3Instance FMI3(InstantiateCoSimulation)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
    fmi3Boolean eventModeUsed, fmi3Boolean earlyReturnAllowed, const fmi3ValueReference requiredIntermediateVariables[],
    size_t nRequiredIntermediateVariables, fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage,
    fmi3IntermediateUpdateCallback intermediateUpdate)
{
    (void)resourcePath;
    (void)visible;
    (void)earlyReturnAllowed;
    (void)requiredIntermediateVariables;
    (void)nRequiredIntermediateVariables;
    (void)intermediateUpdate;
    return instantiated(
        instanceName, instantiationToken, loggingOn, instanceEnvironment, logMessage, eventModeUsed ? WITH_EVENTS : WITHOUT_EVENTS);
}

SIGCAT_EXPORT fmi3Instance FMI3(InstantiateScheduledExecution)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
    fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage, fmi3ClockUpdateCallback clockUpdate,
    fmi3LockPreemptionCallback lockPreemption, fmi3UnlockPreemptionCallback unlockPreemption)
{
    component *const self =
        instantiated(instanceName, instantiationToken, loggingOn, instanceEnvironment, logMessage, SCHEDULED);
    (void)resourcePath;
    (void)visible;
    (void)clockUpdate;
    if ((self != NULL) && (lockPreemption != NULL) && (unlockPreemption != NULL)) {
        self->lock = lockPreemption;
        self->unlock = unlockPreemption;
    }
    return self;
}

SIGCAT_EXPORT void FMI3(FreeInstance)(fmi3Instance instance)
{
    if (instance != NULL) {
        free_component((component *)instance);
        is_instantiated = false;
    }
}

SIGCAT_EXPORT fmi3Status FMI3(EnterInitializationMode)(
    fmi3Instance instance, fmi3Boolean toleranceDefined, fmi3Float64 tolerance, fmi3Float64 startTime, fmi3Boolean stopTimeDefined,
    fmi3Float64 stopTime)
{
    component *const self = in_phase(instance, INSTANTIATED, "fmi3EnterInitializationMode is called once, first.");
    (void)toleranceDefined;
    (void)tolerance;
    if (self == NULL) {
        return fmi3Error;
    }
    if (!((startTime >= -LONGEST) && (startTime <= LONGEST)) || (stopTimeDefined && !(stopTime >= startTime))) {
        return told(self, fmi3Error, "The start time must be a number, within 9e6 s, and not after the stop time.");
    }
    self->at.start = startTime;
    self->at.phase = INITIALIZATION;
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(ExitInitializationMode)(fmi3Instance instance)
{
    component *const self = in_phase(instance, INITIALIZATION, "fmi3ExitInitializationMode ends the initialization mode.");
    bool is_ready = true;
    if (self == NULL) {
        return fmi3Error;
    }
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        is_ready = sigcat_model.functions[i]->start_up(self->states[i], 0U) && is_ready;
    }
    if (!take_parameters(self)) {
        return told(self, fmi3Error, "A parameter is out of its range.");
    }
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        sigcat_model.functions[i]->start(self->states[i], self->at.now);
        sigcat_model.functions[i]->send(self->states[i], &self->host);
    }
    self->at.phase = after_initialization[self->at.usage];
    return is_ready ? fmi3OK : told(self, fmi3Warning, "Init of a function has failed: its safety reactions are active.");
}

SIGCAT_EXPORT fmi3Status FMI3(Terminate)(fmi3Instance instance)
{
    component *const self = (component *)instance;
    if ((self == NULL) || ((self->at.phase != STEP) && (self->at.phase != EVENT) && (self->at.phase != ACTIVATION))) {
        return told(self, fmi3Error, "fmi3Terminate is called after the initialization, once.");
    }
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        sigcat_model.functions[i]->terminate_at(self->states[i], self->at.now);
        sigcat_model.functions[i]->send(self->states[i], &self->host);
    }
    self->at.phase = TERMINATED;
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(Reset)(fmi3Instance instance)
{
    component *const self = (component *)instance;
    if (self == NULL) {
        return fmi3Error;
    }
    if (sigcat_model.is_single) {
        return told(self, fmi3Error, "The code has global variables, which cannot be reset. Start another process.");
    }
    destroy_states(self);
    if (!create_states(self)) {
        return told(self, fmi3Fatal, "No memory is left.");
    }
    begin_again(self, self->at.usage);
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(EnterEventMode)(fmi3Instance instance)
{
    component *const self = in_phase(instance, STEP, "fmi3EnterEventMode is called in step mode.");
    if (self == NULL) {
        return fmi3Error;
    }
    if (self->at.usage != WITH_EVENTS) {
        return told(self, fmi3Error, "An instance has an event mode if it is instantiated with eventModeUsed.");
    }
    self->at.phase = EVENT;
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(EnterStepMode)(fmi3Instance instance)
{
    component *const self = in_phase(instance, EVENT, "fmi3EnterStepMode ends the event mode.");
    if (self == NULL) {
        return fmi3Error;
    }
    self->at.phase = STEP;
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(UpdateDiscreteStates)(
    fmi3Instance instance, fmi3Boolean *discreteStatesNeedUpdate, fmi3Boolean *terminateSimulation,
    fmi3Boolean *nominalsOfContinuousStatesChanged, fmi3Boolean *valuesOfContinuousStatesChanged, fmi3Boolean *nextEventTimeDefined,
    fmi3Float64 *nextEventTime)
{
    component *const self = in_phase(instance, EVENT, "fmi3UpdateDiscreteStates is called in event mode.");
    bool is_whole = true;
    if ((self == NULL) || (discreteStatesNeedUpdate == NULL) || (terminateSimulation == NULL)
        || (nominalsOfContinuousStatesChanged == NULL) || (valuesOfContinuousStatesChanged == NULL) || (nextEventTimeDefined == NULL)
        || (nextEventTime == NULL)) {
        return told(self, fmi3Error, "fmi3UpdateDiscreteStates needs places for its results.");
    }
    *discreteStatesNeedUpdate = false;
    *terminateSimulation = false;
    *nominalsOfContinuousStatesChanged = false;
    *valuesOfContinuousStatesChanged = false;
    *nextEventTimeDefined = false;
    *nextEventTime = 0.0;
    if (!take_parameters(self)) {
        return told(self, fmi3Error, OUT_OF_RANGE);
    }
    if (has_bus(self)) {
        is_whole = sigcat_model.bus->clear_sent(self->bus);
        self->at.is_announced = false;
        receive_bus(self);
    }
    receive_inputs(self);
    if (!run_calls(self)) {
        return told(self, fmi3Error, ENDLESS);
    }
    *discreteStatesNeedUpdate = has_sent(self);
    return is_whole ? fmi3OK : told(self, fmi3Warning, LOST);
}

/* In s since the start of the simulation to ns since then; false if it is not a time of this instance. */
static bool to_nanoseconds(const component *self, double time, uint64_t *found)
{
    const double since = time - self->at.start;
    const bool is_time = (since >= 0.0) && (since <= LONGEST);
    *found = is_time ? (uint64_t)((since * NANOSECONDS) + 0.5) : 0U;
    return is_time;
}

SIGCAT_EXPORT fmi3Status FMI3(DoStep)(
    fmi3Instance instance, fmi3Float64 currentCommunicationPoint, fmi3Float64 communicationStepSize,
    fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean *eventHandlingNeeded, fmi3Boolean *terminateSimulation,
    fmi3Boolean *earlyReturn, fmi3Float64 *lastSuccessfulTime)
{
    component *const self = in_phase(instance, STEP, "fmi3DoStep is called in step mode.");
    uint64_t begin;
    uint64_t end;
    (void)noSetFMUStatePriorToCurrentPoint;
    if ((self == NULL) || (eventHandlingNeeded == NULL) || (terminateSimulation == NULL) || (earlyReturn == NULL)
        || (lastSuccessfulTime == NULL)) {
        return told(self, fmi3Error, "fmi3DoStep needs places for its results.");
    }
    *eventHandlingNeeded = false;
    *terminateSimulation = false;
    *earlyReturn = false;
    *lastSuccessfulTime = self->at.start + ((double)self->at.now / NANOSECONDS);
    if (!to_nanoseconds(self, currentCommunicationPoint, &begin) || (begin != self->at.now)) {
        return told(self, fmi3Error, "A step must begin where the one before it has ended.");
    }
    if (!(communicationStepSize > 0.0) || !to_nanoseconds(self, currentCommunicationPoint + communicationStepSize, &end)) {
        return told(self, fmi3Error, "A step must be longer than 0, and end within 9e6 s.");
    }
    if (!take_parameters(self)) {
        return told(self, fmi3Error, OUT_OF_RANGE);
    }
    receive_inputs(self);
    if (!run_until(self, end)) {
        return told(self, fmi3Error, ENDLESS);
    }
    *eventHandlingNeeded = (self->at.usage == WITH_EVENTS) && (is_due(self) || has_sent(self));
    *lastSuccessfulTime = currentCommunicationPoint + communicationStepSize;
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(ActivateModelPartition)(
    fmi3Instance instance, fmi3ValueReference clockReference, fmi3Float64 activationTime)
{
    component *const self = in_phase(instance, ACTIVATION, "fmi3ActivateModelPartition is called in clock activation mode.");
    const uint32_t call = clockReference - sigcat_model.variable_count; /* wraps round for a variable */
    uint64_t now;
    bool is_taken;
    bool is_done;
    if (self == NULL) {
        return fmi3Error;
    }
    if (call >= sigcat_model.call_count) {
        return told(self, fmi3Error, "A clock reference is not a clock of modelDescription.xml.");
    }
    if (!to_nanoseconds(self, activationTime, &now) || (now < self->at.now)) {
        return told(self, fmi3Error, "An activation must not be before the one before it, and within 9e6 s.");
    }
    lock(self);
    self->at.now = now;
    is_taken = take_parameters(self);
    receive_inputs(self);
    is_done = run_activated(self, call);
    unlock(self);
    if (!is_done) {
        return told(self, fmi3Error, ENDLESS);
    }
    return is_taken ? fmi3OK : told(self, fmi3Warning, OUT_OF_RANGE);
}

/* -- values ------------------------------------------------------------------------------------------------------ */

static int64_t number_at(const unsigned char *bytes, sigcat_type type)
{
    int64_t found = 0;
    int8_t i8;
    int16_t i16;
    int32_t i32;
    uint16_t u16;
    uint32_t u32;
    switch (type) {
        case SIGCAT_INT8: (void)memcpy(&i8, bytes, sizeof(i8)); found = i8; break;
        case SIGCAT_UINT8: found = bytes[0]; break;
        case SIGCAT_INT16: (void)memcpy(&i16, bytes, sizeof(i16)); found = i16; break;
        case SIGCAT_UINT16: (void)memcpy(&u16, bytes, sizeof(u16)); found = u16; break;
        case SIGCAT_INT32: (void)memcpy(&i32, bytes, sizeof(i32)); found = i32; break;
        case SIGCAT_UINT32: (void)memcpy(&u32, bytes, sizeof(u32)); found = u32; break;
        default: (void)memcpy(&found, bytes, sizeof(found)); break;
    }
    return found;
}

/* False if the type does not hold the number. */
static bool put_number(unsigned char *bytes, sigcat_type type, int64_t number)
{
    unsigned char made[sizeof(number)];
    const int8_t i8 = (int8_t)number;
    const uint8_t u8 = (uint8_t)number;
    const int16_t i16 = (int16_t)number;
    const uint16_t u16 = (uint16_t)number;
    const int32_t i32 = (int32_t)number;
    const uint32_t u32 = (uint32_t)number;
    switch (type) {
        case SIGCAT_INT8: (void)memcpy(made, &i8, sizeof(i8)); break;
        case SIGCAT_UINT8: (void)memcpy(made, &u8, sizeof(u8)); break;
        case SIGCAT_INT16: (void)memcpy(made, &i16, sizeof(i16)); break;
        case SIGCAT_UINT16: (void)memcpy(made, &u16, sizeof(u16)); break;
        case SIGCAT_INT32: (void)memcpy(made, &i32, sizeof(i32)); break;
        case SIGCAT_UINT32: (void)memcpy(made, &u32, sizeof(u32)); break;
        default: (void)memcpy(made, &number, sizeof(number)); break;
    }
    if (number_at(made, type) != number) {
        return false;
    }
    (void)memcpy(bytes, made, sizes[type]);
    return true;
}

/* NULL, with a message, if there is no such variable of the type, or no room for it among the values. */
static const sigcat_variable *variable_of(const component *self, fmi3ValueReference reference, sigcat_type type, size_t room)
{
    const sigcat_variable *const found = (reference < sigcat_model.variable_count) ? &sigcat_model.variables[reference] : NULL;
    if (found == NULL) {
        (void)told(self, fmi3Error, "A value reference is not one of modelDescription.xml.");
        return NULL;
    }
    if ((found->is_enumeration ? SIGCAT_INT64 : found->type) != type) {
        (void)told(self, fmi3Error, "A variable has another type in modelDescription.xml.");
        return NULL;
    }
    if (found->count > room) {
        (void)told(self, fmi3Error, "There are fewer values than the variables have elements.");
        return NULL;
    }
    return found;
}

static fmi3Status get_one(component *self, const sigcat_variable *variable, unsigned char *to)
{
    const unsigned char *const from = &self->values[variable->offset];
    if (variable->causality == SIGCAT_TIME) {
        const double time = self->at.start + ((double)self->at.now / NANOSECONDS);
        (void)memcpy(to, &time, sizeof(time));
    } else if (variable->is_enumeration) {
        for (uint32_t i = 0; i < variable->count; i++) {
            const int64_t number = number_at(&from[i * sizes[variable->type]], variable->type);
            (void)memcpy(&to[i * sizeof(number)], &number, sizeof(number));
        }
    } else {
        (void)memcpy(to, from, variable->count * sizes[variable->type]);
    }
    return fmi3OK;
}

static fmi3Status get(
    fmi3Instance instance, const fmi3ValueReference references[], size_t count, void *values, size_t value_count, sigcat_type type)
{
    component *const self = (component *)instance;
    unsigned char *const to = (unsigned char *)values;
    size_t at = 0;
    if ((self == NULL) || ((count > 0U) && ((references == NULL) || (values == NULL)))) {
        return told(self, fmi3Error, "Value references and values must be there.");
    }
    for (size_t i = 0; i < count; i++) {
        const sigcat_variable *const variable = variable_of(self, references[i], type, value_count - at);
        if (variable == NULL) {
            return fmi3Error;
        }
        (void)get_one(self, variable, &to[at * sizes[type]]);
        at += variable->count;
    }
    return (at == value_count) ? fmi3OK : told(self, fmi3Error, "There are more values than the variables have elements.");
}

static fmi3Status set_one(component *self, const sigcat_variable *variable, const unsigned char *from)
{
    unsigned char *const to = &self->values[variable->offset];
    if (variable->is_enumeration) {
        for (uint32_t i = 0; i < variable->count; i++) {
            int64_t number;
            (void)memcpy(&number, &from[i * sizeof(number)], sizeof(number));
            if (!put_number(&to[i * sizes[variable->type]], variable->type, number)) {
                return told(self, fmi3Error, "A number is out of the range of the enumeration's datatype.");
            }
        }
    } else {
        (void)memcpy(to, from, variable->count * sizes[variable->type]);
    }
    if (variable->causality == SIGCAT_INPUT) {
        self->is_set[variable->owner] = true;
    } else {
        self->has_parameters[variable->owner] = true;
    }
    return fmi3OK;
}

static fmi3Status set(
    fmi3Instance instance, const fmi3ValueReference references[], size_t count, const void *values, size_t value_count,
    sigcat_type type)
{
    component *const self = (component *)instance;
    const unsigned char *const from = (const unsigned char *)values;
    size_t at = 0;
    fmi3Status status = fmi3OK;
    if ((self == NULL) || ((count > 0U) && ((references == NULL) || (values == NULL)))) {
        return told(self, fmi3Error, "Value references and values must be there.");
    }
    if (self->at.phase == TERMINATED) {
        return told(self, fmi3Error, "Nothing is set after fmi3Terminate.");
    }
    for (size_t i = 0; (i < count) && (status == fmi3OK); i++) {
        const sigcat_variable *const variable = variable_of(self, references[i], type, value_count - at);
        if (variable == NULL) {
            return fmi3Error;
        }
        if ((variable->causality != SIGCAT_INPUT) && (variable->causality != SIGCAT_PARAMETER)) {
            return told(self, fmi3Error, "Only inputs and parameters are set.");
        }
        status = set_one(self, variable, &from[at * sizes[type]]);
        at += variable->count;
    }
    if ((status == fmi3OK) && (at != value_count)) {
        status = told(self, fmi3Error, "There are more values than the variables have elements.");
    }
    return status;
}

#define ACCESS(name, type, kind) \
    SIGCAT_EXPORT fmi3Status FMI3(Get##name)( \
        fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, type values[], size_t nValues) \
    { \
        return get(instance, valueReferences, nValueReferences, values, nValues, kind); \
    } \
    SIGCAT_EXPORT fmi3Status FMI3(Set##name)( \
        fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const type values[], \
        size_t nValues) \
    { \
        return set(instance, valueReferences, nValueReferences, values, nValues, kind); \
    }

ACCESS(Float32, fmi3Float32, SIGCAT_FLOAT32)
ACCESS(Float64, fmi3Float64, SIGCAT_FLOAT64)
ACCESS(Int8, fmi3Int8, SIGCAT_INT8)
ACCESS(UInt8, fmi3UInt8, SIGCAT_UINT8)
ACCESS(Int16, fmi3Int16, SIGCAT_INT16)
ACCESS(UInt16, fmi3UInt16, SIGCAT_UINT16)
ACCESS(Int32, fmi3Int32, SIGCAT_INT32)
ACCESS(UInt32, fmi3UInt32, SIGCAT_UINT32)
ACCESS(Int64, fmi3Int64, SIGCAT_INT64)
ACCESS(UInt64, fmi3UInt64, SIGCAT_UINT64)
ACCESS(Boolean, fmi3Boolean, SIGCAT_BOOLEAN)

/* -- bus ---------------------------------------------------------------------------------------------------------- */

/* An instance whose bus has all of these variables; NULL, with a message, otherwise. */
static component *with_bus(fmi3Instance instance, const fmi3ValueReference references[], size_t count, const void *values, uint32_t allowed)
{
    component *const self = (component *)instance;
    if ((self == NULL) || ((self->at.phase != EVENT) && (self->at.phase != INITIALIZATION))) {
        (void)told(self, fmi3Error, "Clocks and binary variables are used in event mode and in initialization mode.");
        return NULL;
    }
    if ((count > 0U) && ((references == NULL) || (values == NULL))) {
        (void)told(self, fmi3Error, "Value references and values must be there.");
        return NULL;
    }
    for (size_t i = 0; i < count; i++) {
        const uint32_t number = references[i] - sigcat_model.variable_count; /* wraps round for a variable */
        if (!has_bus(self) || (number >= (uint32_t)SIGCAT_BUS_VARIABLES) || (((allowed >> number) & 1U) == 0U)) {
            (void)told(self, fmi3Error, "A value reference is not one of a bus, of this type and causality.");
            return NULL;
        }
    }
    return self;
}

#define ONE(variable) (1U << (uint32_t)(variable))

SIGCAT_EXPORT fmi3Status FMI3(GetClock)(
    fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3Clock values[])
{
    component *const self =
        with_bus(instance, valueReferences, nValueReferences, values, ONE(SIGCAT_RX_CLOCK) | ONE(SIGCAT_TX_CLOCK));
    if (self == NULL) {
        return fmi3Error;
    }
    for (size_t i = 0; i < nValueReferences; i++) {
        if ((valueReferences[i] - sigcat_model.variable_count) == (uint32_t)SIGCAT_RX_CLOCK) {
            values[i] = self->at.is_received;
        } else {
            values[i] = has_sent(self) && !self->at.is_announced; /* it is active once */
            self->at.is_announced = self->at.is_announced || values[i];
        }
    }
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(SetClock)(
    fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const fmi3Clock values[])
{
    component *const self = with_bus(instance, valueReferences, nValueReferences, values, ONE(SIGCAT_RX_CLOCK));
    if (self == NULL) {
        return fmi3Error;
    }
    for (size_t i = 0; i < nValueReferences; i++) {
        self->at.is_received = values[i];
    }
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(GetBinary)(
    fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, size_t valueSizes[], fmi3Binary values[],
    size_t nValues)
{
    component *const self =
        with_bus(instance, valueReferences, nValueReferences, values, ONE(SIGCAT_RX_DATA) | ONE(SIGCAT_TX_DATA));
    if (self == NULL) {
        return fmi3Error;
    }
    if ((nValues != nValueReferences) || ((nValues > 0U) && (valueSizes == NULL))) {
        return told(self, fmi3Error, "Each binary variable has one value, with a size.");
    }
    for (size_t i = 0; i < nValues; i++) {
        const bool is_sent = (valueReferences[i] - sigcat_model.variable_count) == (uint32_t)SIGCAT_TX_DATA;
        values[i] = is_sent ? sigcat_model.bus->get_sent(self->bus, &valueSizes[i])
                            : sigcat_model.bus->get_received(self->bus, &valueSizes[i]);
    }
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(SetBinary)(
    fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const size_t valueSizes[],
    const fmi3Binary values[], size_t nValues)
{
    component *const self = with_bus(instance, valueReferences, nValueReferences, values, ONE(SIGCAT_RX_DATA));
    if (self == NULL) {
        return fmi3Error;
    }
    if ((nValues != nValueReferences) || ((nValues > 0U) && (valueSizes == NULL))) {
        return told(self, fmi3Error, "Each binary variable has one value, with a size.");
    }
    for (size_t i = 0; i < nValues; i++) {
        if ((valueSizes[i] > 0U) && (values[i] == NULL)) {
            return told(self, fmi3Error, "A binary value must be there.");
        }
        if (!sigcat_model.bus->set_received(self->bus, values[i], valueSizes[i])) {
            return told(self, fmi3Error, "Rx_Data has more bytes than a bus of this FMU takes at once.");
        }
    }
    return fmi3OK;
}

/* -- state ------------------------------------------------------------------------------------------------------- */

static size_t saved_size(void)
{
    size_t found = sizeof(progress) + sigcat_model.value_count + sigcat_model.input_count + sigcat_model.function_count + sigcat_model.call_count
        + ((sigcat_model.bus != NULL) ? sigcat_model.bus->state_size : 0U);
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        found += sigcat_model.functions[i]->state_size;
    }
    return found;
}

static void save(const component *self, unsigned char *to)
{
    to = sigcat_put(to, &self->at, sizeof(self->at));
    to = sigcat_put(to, self->values, sigcat_model.value_count);
    to = sigcat_put(to, self->is_set, sigcat_model.input_count);
    to = sigcat_put(to, self->has_parameters, sigcat_model.function_count);
    to = sigcat_put(to, self->is_waiting, sigcat_model.call_count);
    if (self->bus != NULL) {
        to = sigcat_put(to, self->bus, sigcat_model.bus->state_size);
    }
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        to = sigcat_put(to, self->states[i], sigcat_model.functions[i]->state_size);
    }
}

static void restore(component *self, const unsigned char *from)
{
    from = sigcat_take(from, &self->at, sizeof(self->at));
    from = sigcat_take(from, self->values, sigcat_model.value_count);
    from = sigcat_take(from, self->is_set, sigcat_model.input_count);
    from = sigcat_take(from, self->has_parameters, sigcat_model.function_count);
    from = sigcat_take(from, self->is_waiting, sigcat_model.call_count);
    if (self->bus != NULL) {
        from = sigcat_take(from, self->bus, sigcat_model.bus->state_size);
    }
    for (uint32_t i = 0; i < sigcat_model.function_count; i++) {
        from = sigcat_take(from, self->states[i], sigcat_model.functions[i]->state_size);
    }
}

static component *saving(fmi3Instance instance, const void *place)
{
    component *const self = (component *)instance;
    if ((self == NULL) || (place == NULL)) {
        (void)told(self, fmi3Error, "A state and its place must be there.");
        return NULL;
    }
    if (!sigcat_model.is_copied) {
        (void)told(self, fmi3Error, "The state of this FMU cannot be saved: its code keeps data outside of it.");
        return NULL;
    }
    return self;
}

SIGCAT_EXPORT fmi3Status FMI3(GetFMUState)(fmi3Instance instance, fmi3FMUState *FMUState)
{
    const component *const self = saving(instance, FMUState);
    if (self == NULL) {
        return fmi3Error;
    }
    if (*FMUState == NULL) {
        *FMUState = malloc(saved_size());
    }
    if (*FMUState == NULL) {
        return told(self, fmi3Error, "No memory is left.");
    }
    save(self, (unsigned char *)*FMUState);
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(SetFMUState)(fmi3Instance instance, fmi3FMUState FMUState)
{
    component *const self = saving(instance, FMUState);
    progress saved;
    if (self == NULL) {
        return fmi3Error;
    }
    (void)memcpy(&saved, FMUState, sizeof(saved));
    if (saved.usage != self->at.usage) {
        return told(self, fmi3Error, "The state is one of an instance that is used in another way, with or without event mode.");
    }
    restore(self, (const unsigned char *)FMUState);
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(FreeFMUState)(fmi3Instance instance, fmi3FMUState *FMUState)
{
    if (instance == NULL) {
        return fmi3Error;
    }
    if (FMUState != NULL) {
        free(*FMUState);
        *FMUState = NULL;
    }
    return fmi3OK;
}

/* A state in bytes begins with a sum over the token and the rest: those of another FMU, or damaged ones, are refused. */
static uint64_t sum_of(const unsigned char *bytes, size_t size)
{
    uint64_t sum = UINT64_C(14695981039346656037);
    for (const char *each = sigcat_model.token; *each != '\0'; each++) {
        sum = (sum ^ (unsigned char)*each) * UINT64_C(1099511628211);
    }
    for (size_t i = 0; i < size; i++) {
        sum = (sum ^ bytes[i]) * UINT64_C(1099511628211);
    }
    return sum;
}

SIGCAT_EXPORT fmi3Status FMI3(SerializedFMUStateSize)(fmi3Instance instance, fmi3FMUState FMUState, size_t *size)
{
    const component *const self = saving(instance, FMUState);
    if ((self == NULL) || (size == NULL)) {
        return fmi3Error;
    }
    *size = saved_size() + sizeof(uint64_t);
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(SerializeFMUState)(fmi3Instance instance, fmi3FMUState FMUState, fmi3Byte serializedState[], size_t size)
{
    const component *const self = saving(instance, FMUState);
    uint64_t sum;
    if ((self == NULL) || (serializedState == NULL) || (size != (saved_size() + sizeof(sum)))) {
        return told(self, fmi3Error, "A state needs as many bytes as fmi3SerializedFMUStateSize says.");
    }
    sum = sum_of((const unsigned char *)FMUState, saved_size());
    (void)memcpy(serializedState, &sum, sizeof(sum));
    (void)memcpy(&serializedState[sizeof(sum)], FMUState, saved_size());
    return fmi3OK;
}

SIGCAT_EXPORT fmi3Status FMI3(DeserializeFMUState)(
    fmi3Instance instance, const fmi3Byte serializedState[], size_t size, fmi3FMUState *FMUState)
{
    const component *const self = saving(instance, FMUState);
    uint64_t sum;
    if ((self == NULL) || (serializedState == NULL) || (size != (saved_size() + sizeof(sum)))) {
        return told(self, fmi3Error, "A state has as many bytes as fmi3SerializedFMUStateSize says.");
    }
    (void)memcpy(&sum, serializedState, sizeof(sum));
    if (sum != sum_of(&serializedState[sizeof(sum)], saved_size())) {
        return told(self, fmi3Error, "The bytes are damaged, or are a state of another FMU.");
    }
    if (*FMUState == NULL) {
        *FMUState = malloc(saved_size());
    }
    if (*FMUState == NULL) {
        return told(self, fmi3Error, "No memory is left.");
    }
    (void)memcpy(*FMUState, &serializedState[sizeof(sum)], saved_size());
    return fmi3OK;
}

/* -- what this FMU does not offer, as its modelDescription.xml says ----------------------------------------------- */

SIGCAT_EXPORT fmi3Instance FMI3(InstantiateModelExchange)(
    fmi3String instanceName, fmi3String instantiationToken, fmi3String resourcePath, fmi3Boolean visible, fmi3Boolean loggingOn,
    fmi3InstanceEnvironment instanceEnvironment, fmi3LogMessageCallback logMessage)
{
    (void)instanceName;
    (void)instantiationToken;
    (void)resourcePath;
    (void)visible;
    (void)loggingOn;
    return refused(logMessage, instanceEnvironment, "This FMU has no model exchange.");
}

/* Arguments have the names of the standard, and none is used. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-parameter"
#endif
#define NOT_OFFERED(name, ...) \
    SIGCAT_EXPORT fmi3Status FMI3(name)(__VA_ARGS__) \
    { \
        return not_offered(instance); \
    }

NOT_OFFERED(GetString, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, fmi3String
    values[], size_t nValues)
NOT_OFFERED(SetString, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const
    fmi3String values[], size_t nValues)
NOT_OFFERED(GetNumberOfVariableDependencies, fmi3Instance instance, fmi3ValueReference valueReference, size_t *nDependencies)
NOT_OFFERED(GetVariableDependencies, fmi3Instance instance, fmi3ValueReference dependent, size_t elementIndicesOfDependent[],
    fmi3ValueReference independents[], size_t elementIndicesOfIndependents[], fmi3DependencyKind dependencyKinds[], size_t
    nDependencies)
NOT_OFFERED(GetDirectionalDerivative, fmi3Instance instance, const fmi3ValueReference unknowns[], size_t nUnknowns, const
    fmi3ValueReference knowns[], size_t nKnowns, const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[], size_t
    nSensitivity)
NOT_OFFERED(GetAdjointDerivative, fmi3Instance instance, const fmi3ValueReference unknowns[], size_t nUnknowns, const
    fmi3ValueReference knowns[], size_t nKnowns, const fmi3Float64 seed[], size_t nSeed, fmi3Float64 sensitivity[], size_t
    nSensitivity)
NOT_OFFERED(EnterConfigurationMode, fmi3Instance instance)
NOT_OFFERED(ExitConfigurationMode, fmi3Instance instance)
NOT_OFFERED(GetIntervalDecimal, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[])
NOT_OFFERED(GetIntervalFraction, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3UInt64 counters[], fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[])
NOT_OFFERED(GetShiftDecimal, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3Float64 shifts[])
NOT_OFFERED(GetShiftFraction, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    fmi3UInt64 counters[], fmi3UInt64 resolutions[])
NOT_OFFERED(SetIntervalDecimal, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const
    fmi3Float64 intervals[])
NOT_OFFERED(SetIntervalFraction, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const
    fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
NOT_OFFERED(SetShiftDecimal, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const
    fmi3Float64 shifts[])
NOT_OFFERED(SetShiftFraction, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences, const
    fmi3UInt64 counters[], const fmi3UInt64 resolutions[])
NOT_OFFERED(EvaluateDiscreteStates, fmi3Instance instance)
NOT_OFFERED(EnterContinuousTimeMode, fmi3Instance instance)
NOT_OFFERED(CompletedIntegratorStep, fmi3Instance instance, fmi3Boolean noSetFMUStatePriorToCurrentPoint, fmi3Boolean
    *enterEventMode, fmi3Boolean *terminateSimulation)
NOT_OFFERED(SetTime, fmi3Instance instance, fmi3Float64 time)
NOT_OFFERED(SetContinuousStates, fmi3Instance instance, const fmi3Float64 continuousStates[], size_t nContinuousStates)
NOT_OFFERED(GetContinuousStateDerivatives, fmi3Instance instance, fmi3Float64 derivatives[], size_t nContinuousStates)
NOT_OFFERED(GetEventIndicators, fmi3Instance instance, fmi3Float64 eventIndicators[], size_t nEventIndicators)
NOT_OFFERED(GetContinuousStates, fmi3Instance instance, fmi3Float64 continuousStates[], size_t nContinuousStates)
NOT_OFFERED(GetNominalsOfContinuousStates, fmi3Instance instance, fmi3Float64 nominals[], size_t nContinuousStates)
NOT_OFFERED(GetNumberOfEventIndicators, fmi3Instance instance, size_t *nEventIndicators)
NOT_OFFERED(GetNumberOfContinuousStates, fmi3Instance instance, size_t *nContinuousStates)
NOT_OFFERED(GetOutputDerivatives, fmi3Instance instance, const fmi3ValueReference valueReferences[], size_t nValueReferences,
    const fmi3Int32 orders[], fmi3Float64 values[], size_t nValues)

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif
