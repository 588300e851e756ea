"""The source of a node."""

from sigcat.adapter.core.plan import GLOBALS
from sigcat.adapter.ros2.cpp.calls import call_functions
from sigcat.adapter.ros2.cpp.connections import connection_functions
from sigcat.adapter.ros2.cpp.diagnostics import tell_function
from sigcat.adapter.ros2.cpp.layout import comment, function, indented, spaced, text
from sigcat.adapter.ros2.cpp.methods import method_functions
from sigcat.adapter.ros2.cpp.names import CORE, LOCK, copyright_line, core_function, header_of, times_name
from sigcat.adapter.ros2.cpp.node_header import has_messages, messages_of
from sigcat.adapter.ros2.cpp.parameters import initial_parameters, parameter_functions
from sigcat.adapter.ros2.cpp.sending import publish_function
from sigcat.adapter.ros2.cpp.stored import storage_functions
from sigcat.adapter.ros2.cpp.tables import symbol_tables
from sigcat.adapter.ros2.plan import NodePlan, WorkspacePlan
from sigcat.function.document.text_filters import c_format, c_header, c_string

_CORE = "// The core of the function: what it is made of stays in this file."
_STATE = "const rclcpp_lifecycle::State & state"
_NO_STATE = "const rclcpp_lifecycle::State & /* state */"


def node_source(node: NodePlan, workspace: WorkspacePlan) -> str:
    """The whole source."""
    return spaced([
        copyright_line(workspace),
        f"#include {c_header(f'{workspace.name}/{node.stem}.hpp')}",
        _includes(node, workspace),
        text([
            f"namespace {workspace.name}\n{{\n",
            messages_of(workspace)
            if has_messages(node, node.subscriptions) and not has_messages(node, node.publishers) else "",
            "using diagnostic_msgs::msg::DiagnosticStatus;",
        ]),
        _anonymous([*symbol_tables(node), *storage_functions(node)]),
        _core(node),
        _constructor(node),
        _destructor(node),
        *parameter_functions(node, workspace),
        *_life(node),
        _set_clock(node),
        _initialize(node),
        _terminate(node),
        *connection_functions(node, workspace),
        *call_functions(node),
        publish_function(node),
        *method_functions(node),
        tell_function(node),
        f"}}  {comment(f'namespace {workspace.name}')}",
        f'#include "rclcpp_components/register_node_macro.hpp"\n\nRCLCPP_COMPONENTS_REGISTER_NODE({workspace.name}::{node.type})',
    ]) + "\n"  # fmt: skip


def _includes(node: NodePlan, workspace: WorkspacePlan) -> str:
    standard = ["chrono", "memory", "mutex", "string", "vector"]
    standard += ["atomic", "stdexcept"] if node.core.code.signature == GLOBALS else []
    own = ["diagnostics", "guard", "parameters", "values", *(["scheduling"] if node.priority is not None else [])]
    own += ["structs"] if node.structs else []
    headers = [
        f"{workspace.name}/{node.name}_structs.hpp" if each == "structs" else f"{workspace.name}/{each}.hpp"
        for each in own
    ]
    headers += [header_of(each.message) for each in node.subscriptions]
    headers.append(node.core.header_file)
    return spaced([
        "\n".join(f"#include <{each}>" for each in sorted(standard)),
        "\n".join(f"#include {c_header(each)}" for each in sorted(set(headers))),
    ])  # fmt: skip


def _anonymous(parts: list[str]) -> str:
    return spaced(["namespace\n{", *parts, "}  // namespace"]) if parts else ""


def _core(node: NodePlan) -> str:
    """What the header does not tell: the core and its types."""
    prefix = node.core.type_name
    parameters = f"{prefix}_Parameters parameters{{}};  // as the node has them" if node.settable else ""
    if node.core.code.signature != GLOBALS:
        return text(
            [_CORE, f"struct {node.type}::Core\n{{", indented(text([f"{prefix} adapter{{}};", parameters])), "};"]
        )
    once = f"{node.core.function} keeps its data in global variables: a process can have one node of it"
    return text([
        _CORE,
        f"struct {node.type}::Core\n{{",
        indented(spaced([
            function("Core()", [f"if (is_held.exchange(true)) {{\n  constexpr char kOnce[] =\n    {c_string(once)};\n  throw std::runtime_error(kOnce);\n}}"]),
            "~Core() {is_held = false;}\nCore(const Core &) = delete;\nCore & operator=(const Core &) = delete;",
            text([f"{prefix} & adapter = {prefix}_Instance;", parameters, "static inline std::atomic<bool> is_held{false};"]),
        ])),
        "};",
    ])  # fmt: skip


def _constructor(node: NodePlan) -> str:
    kind = "rclcpp::CallbackGroupType::MutuallyExclusive"
    return text([
        f"{node.type}::{node.type}(const rclcpp::NodeOptions & options)",
        f": LifecycleNode({c_string(node.name)}, options),",
        indented(text([
            "core_(std::make_unique<Core>()),",
            f"receiving_(create_callback_group({kind}, false)),",
            f"answering_(create_callback_group({kind}))",
        ])),
        "{\n  declare_parameters();\n}",
    ])  # fmt: skip


def _destructor(node: NodePlan) -> str:
    return function(f"{node.type}::~{node.type}()", ["stop_calls();\nterminate();"])


# -- life cycle ---------------------------------------------------------------------------------------------------


def _life(node: NodePlan) -> list[str]:
    success = "return CallbackReturn::SUCCESS;"
    head = f"{node.type}::CallbackReturn {node.type}"
    ended = "terminate();\ndisconnect();"
    return [
        function(f"{head}::on_configure({_NO_STATE})", [_configured(node)]),
        function(f"{head}::on_activate({_STATE})", [
            "const CallbackReturn result = LifecycleNode::on_activate(state);  // of the publishers\nstart_calls();\nreturn result;"]),
        function(f"{head}::on_deactivate({_STATE})", [
            "stop_calls();\nreturn LifecycleNode::on_deactivate(state);  // subscriptions go on storing"]),
        function(f"{head}::on_cleanup({_NO_STATE})", [f"{ended}\n{success}"]),
        function(f"{head}::on_shutdown({_NO_STATE})", [f"stop_calls();\n{ended}\n{success}"]),
        function(f"{head}::on_error({_NO_STATE})", [
            f'RCLCPP_ERROR(get_logger(), "a transition has failed; the node starts over");\nstop_calls();\n{ended}\n{success}']),
    ]  # fmt: skip


def _configured(node: NodePlan) -> str:
    storage = """storage_ = std::make_unique<Storage>(
  storage_file(
    get_parameter("storage_folder").as_string(),
    get_node_base_interface()->get_fully_qualified_name(),
    get_node_base_interface()->get_context()->get_domain_id()),
  get_logger());
""" if node.is_stored else ""  # fmt: skip
    return f"""set_clock();
topics_.keep_all(step_clock_ != nullptr);
{storage}if (!initialize()) {{
  RCLCPP_ERROR(get_logger(), {c_format(f"the initialization of {node.core.function} has failed")});
  return CallbackReturn::FAILURE;
}}
advertise();
subscribe_all();
offer();
diagnostics_ = rclcpp::create_publisher<diagnostic_msgs::msg::DiagnosticArray>(
  *this, "/diagnostics", rclcpp::QoS(rclcpp::KeepLast(1)));
diagnostics_timer_ = create_wall_timer(std::chrono::seconds(1), [this] {{tell();}});
receiver_ = std::make_unique<Receiver>(get_node_base_interface(), receiving_, get_logger());
return CallbackReturn::SUCCESS;"""


def _set_clock(node: NodePlan) -> str:
    return function(f"void {node.type}::set_clock()", [
        """std::shared_ptr<StepClock> step_clock;
std::shared_ptr<Clock> clock;
if (get_parameter("lock_step").as_bool()) {
  step_clock = std::make_shared<StepClock>();
  clock = step_clock;
} else if (get_parameter("use_sim_time").as_bool()) {
  clock = std::make_shared<SimulatedClock>(get_clock());
} else {
  clock = std::make_shared<SteadyClock>(get_clock());
}""",
        f"{LOCK}\nstep_clock_ = step_clock;\nclock_ = clock;",
    ], "// An answer to a request of the last time may still ask the one before.")  # fmt: skip


def _initialize(node: NodePlan) -> str:
    core = node.core.type_name
    load = f"{core}_Stored stored = load(*storage_);" if node.is_stored else f"{core}_Stored stored{{}};"
    taken = "\n".join(f"core_->parameters.{name} = core_->adapter.parameter.{name}.value;" for name in unset(node))
    return function(f"bool {node.type}::initialize()", [
        load,
        *initial_parameters(node),
        LOCK,
        *(f"{name} = CallTimes{{}};" for name in _times(node)),
        f"is_initialized_ = {core_function(node, 'Init')}({CORE}, &stored, stored.ignition_cycle + 1U);",
        taken,
        "return is_initialized_;",
    ])  # fmt: skip


def _times(node: NodePlan) -> list[str]:
    return [times_name(node, step) for step in node.steps]


def unset(node: NodePlan) -> list[str]:
    """Parameters of the core that the node has none for: structs."""
    known = {each.parameter.named.name for each in node.parameters}
    return [
        each.named.name for each in node.core.parameters if each.learned is None and each.named.name not in known
    ] if node.settable else []  # fmt: skip


def _terminate(node: NodePlan) -> str:
    store = "store(core_->adapter.stored, *storage_);" if node.is_stored else ""
    return function(f"void {node.type}::terminate()", [
        "if (!is_initialized_) {\n  return;\n}",
        "const std::lock_guard<std::mutex> call(call_mutex_);",
        LOCK,
        "is_initialized_ = false;",
        f"{core_function(node, 'Terminate')}({CORE}, clock_->now());",
        store,
    ], "// Once for each good initialization.")  # fmt: skip
