"""The main function of an executable."""

from sigcat.adapter.autosar_adaptive.application.names import commented
from sigcat.adapter.autosar_adaptive.application.plan import ApplicationPlan, ExecutablePlan
from sigcat.adapter.core.c.lines import Lines, block, lines, spaced
from sigcat.function.document.text_filters import c_header


def main_source(executable: ExecutablePlan, application: ApplicationPlan) -> Lines:
    """The whole source."""
    adapters = "\n".join(f"#include {c_header(f'{component.stem}_adapter.h')}" for component in executable.components)
    return spaced([
        commented(f"{executable.name}: reports to the execution management, and ends when that asks for it."),
        lines("#include <cstdlib>\n#include <iostream>"),
        lines('#include "application/termination.h"\n#include "ara/core/initialization.h"\n'
              '#include "ara/exec/execution_client.h"\n' + adapters),
        lines("namespace {"),
        _run(executable, application),
        lines("}  // namespace"),
        _main(),
    ])  # fmt: skip


def _run(executable: ExecutablePlan, application: ApplicationPlan) -> Lines:
    namespace = "::".join(application.namespace)
    names = [f"{component.stem}_component" for component in executable.components]
    made = [
        lines(f"{namespace}::{component.type} {name};")
        for component, name in zip(executable.components, names, strict=True)
    ]
    starts: list[Lines] = []
    for index, name in enumerate(names):
        undone = "".join(f"    {started}.Stop();\n" for started in reversed(names[:index]))
        starts.append(lines(f"if (!{name}.Start()) {{\n{undone}    return false;\n}}"))
    stops = [lines(f"{name}.Stop();") for name in reversed(names)]
    return block("bool RunApplication()", [
        lines("""
            application::Termination termination;
            const auto client = ara::exec::ExecutionClient::Create([&termination] { termination.Request(); });
            if (!client.HasValue()) {
                std::cerr << "The execution management cannot be reached: " << client.Error().Message() << std::endl;
                return false;
            }
        """),
        *made,
        *starts,
        lines("""
            const auto reported = client.Value().ReportExecutionState(ara::exec::ExecutionState::kRunning);
            if (reported.HasValue()) {
                termination.Wait();
            } else {
                std::cerr << "The state Running cannot be reported: " << reported.Error().Message() << std::endl;
            }
        """),
        *stops,
        lines("return reported.HasValue();"),
    ])  # fmt: skip


def _main() -> Lines:
    return block("int main()", [lines("""
        const auto initialized = ara::core::Initialize();
        if (!initialized.HasValue()) {
            std::cerr << "The platform cannot be initialized: " << initialized.Error().Message() << std::endl;
            return EXIT_FAILURE;
        }
        const bool is_good = RunApplication();
        const bool is_ended = ara::core::Deinitialize().HasValue();
        return is_good && is_ended ? EXIT_SUCCESS : EXIT_FAILURE;
    """)])  # fmt: skip
