"""What runs the calls of a node: when they are due, under supervision; in lock-step, when it is told the time."""

from sigcat.adapter.core.plan import Call
from sigcat.adapter.ros2.cpp.layout import comment, function, scope, text
from sigcat.adapter.ros2.cpp.names import CORE, LOCK, core_function, run_name, scope_of, times_name
from sigcat.adapter.ros2.cpp.node_header import has_deadline
from sigcat.adapter.ros2.plan import NodePlan
from sigcat.function.document.text import composed

_WATCH = """watch_ = std::make_unique<Watch>(
  [this] {guarded(get_logger(), "The calls are not supervised", [this] {supervise();});});"""
_CALLS = f"""calls_ = std::thread(
  [this] {{
    if (!guarded(get_logger(), "The calls have ended", [this] {{run_calls();}})) {{
      {LOCK}
      scheduling_problem_ = "the calls have ended: see the log";
    }}
  }});"""


def call_functions(node: NodePlan) -> list[str]:
    """Definitions of the member functions."""
    return [
        _start_calls(node),
        _stop_calls(node),
        _run_calls(node),
        _start(node),
        _run_due(node),
        *(_run(step, node) for step in node.steps),
        _supervise(node),
        _step(node),
    ]


def _start_calls(node: NodePlan) -> str:
    scheduled = f"""const std::string policy = get_parameter("scheduling_policy").as_string();
{LOCK}
scheduling_problem_ = schedule(calls_, policy, {node.priority});
if (!scheduling_problem_.empty()) {{
  RCLCPP_WARN(get_logger(), "%s", scheduling_problem_.c_str());
}}""" if node.priority is not None else ""  # fmt: skip
    return function(f"void {node.type}::start_calls()", [
        scope("", [LOCK, "is_active_ = true;"]),
        "clock_->resume();",
        scope("if (step_clock_ != nullptr)", [
            "const std::lock_guard<std::mutex> call(call_mutex_);\nstart();\nis_running_ = true;\nreturn;"]),
        _WATCH if has_deadline(node) else "",
        _CALLS,
        scheduled,
    ])  # fmt: skip


def _stop_calls(node: NodePlan) -> str:
    return function(f"void {node.type}::stop_calls()", [
        scope("", [LOCK, "is_active_ = false;"]),
        scope("if (clock_ != nullptr)", ["clock_->stop();"]),
        scope("if (calls_.joinable())", ["calls_.join();"]),
        "watch_.reset();" if has_deadline(node) else "",
        "const std::lock_guard<std::mutex> call(call_mutex_);  // of a step\nis_running_ = false;",
    ], "// Waits for the call that runs.")  # fmt: skip


def _run_calls(node: NodePlan) -> str:
    return function(f"void {node.type}::run_calls()", [
        "if (!clock_->wait_until(1)) {  // simulated time is 0 until it is known\n  return;\n}",
        "start();\nuint64_t next = 0;",
        scope("while (clock_->wait_until(next))", [
            scope("if (clock_->has_gone_back())", [
                'RCLCPP_WARN(get_logger(), "the time has gone back: the clocks start again");\nstart();']),
            scope("", ["const std::lock_guard<std::mutex> call(call_mutex_);", "run_due_call();"]),
            "supervise();",
            LOCK,
            f"next = {core_function(node, 'NextTime')}({CORE});",
        ]),
    ])  # fmt: skip


def _start(node: NodePlan) -> str:
    return function(f"void {node.type}::start()", [
        "const builtin_interfaces::msg::Time stamp = clock_->stamp();",
        scope("", [LOCK, f"{core_function(node, 'Start')}({CORE}, clock_->now());"]),
        "publish(stamp);",
    ])  # fmt: skip


def _run_due(node: NodePlan) -> str:
    names = scope_of(node)
    cases = [f"case {names.call(step.name)}:\n  {run_name(node, step)}();\n  return true;" for step in node.steps]
    cases.append(f"case {names.constant('NO_CALL')}:\ndefault:\n  return false;")
    return function(f"bool {node.type}::run_due_call()", [
        f"{node.core.type_name}_Call due = {names.constant('NO_CALL')};",
        scope("", [LOCK, f"due = {core_function(node, 'NextCall')}({CORE}, clock_->now());"]),
        scope("switch (due)", [text(cases)]),
    ], "// Whether one was due. One at a time: between two of them, methods are answered.")  # fmt: skip


def _run(step: Call, node: NodePlan) -> str:
    begins, ends = _watched(step)
    body = [
        "const builtin_interfaces::msg::Time stamp = clock_->stamp();\nStopwatch watch;",
        scope("", [
            LOCK,
            f"{core_function(node, f'SetInput_{step.name}')}({CORE}, clock_->now());",
            f"{core_function(node, f'Begin_{step.name}')}({CORE}, clock_->now());",
        ]),
        "const uint64_t before = watch.lap();\npublish(stamp);",
        begins,
        "watch.lap();",
        f"{core_function(node, f'Run_{step.name}')}({CORE});",
        "const uint64_t logic = watch.lap();",
        ends,
        scope("", [
            LOCK,
            f"{core_function(node, f'GetOutput_{step.name}')}({CORE}, clock_->now());",
            f"{times_name(node, step)}.add(before + watch.lap(), logic);",
        ]),
        "publish(stamp);",
    ]  # fmt: skip
    words = composed(step.interface, ": ", step.description) if step.description else step.interface
    return function(f"void {node.type}::{run_name(node, step)}()", body, comment(words))


def _watched(step: Call) -> tuple[str, str]:
    if step.deadline is None:
        return "", ""
    longest = f"std::chrono::nanoseconds({step.deadline.most})"
    return scope("if (watch_ != nullptr)", [f"watch_->begin({longest});"]), scope(
        "if (watch_ != nullptr)", ["watch_->end();"]
    )


def _supervise(node: NodePlan) -> str:
    return function(f"void {node.type}::supervise()", [
        scope("", [LOCK, f"{core_function(node, 'Supervise')}({CORE}, clock_->now());"]),
        "publish(clock_->stamp());",
    ])  # fmt: skip


def _step(node: NodePlan) -> str:
    body = f"""response.success = topics_.wait_for_received(request.received, std::chrono::seconds(10));
const std::lock_guard<std::mutex> call(call_mutex_);
if (!response.success) {{
  response.message = "not as many messages have come";
}} else if (!is_running_) {{
  response.success = false;
  response.message = "the node is not active";
}} else if (!request.only_wait) {{
  while (run_due_call()) {{
  }}
  supervise();
  step_clock_->set(request.time);
  {LOCK}
  response.next = {core_function(node, "NextTime")}({CORE});
}}
response.received = topics_.received();
response.sent = topics_.sent();"""
    return function(f"void {node.type}::step(\n  const srv::Step::Request & request, srv::Step::Response & response)", [body],
                    "// Lock-step: what is due now runs, then it is `time`.")  # fmt: skip
