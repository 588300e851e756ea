"""A node that receives SIGTERM ends with status 0, whatever it is doing."""

from contextlib import contextmanager

from scripts import run_ros2
from sigcat.players.ros2_domain import own_domain
from tests.adapter.ros2.built import NODES, preloaded, variables, workspace
from tests.adapter.ros2.other_end import CONFIGURE, peer
from tests.needs import ros2
from tests.waiting import wait_until

pytestmark = ros2

NODE = "core_acc"
ANSWERS_LATE = """#include <chrono>
#include <cstdio>
#include <dlfcn.h>
#include <thread>

extern "C" const void * rcl_publisher_get_context(const void * publisher);
extern "C" bool rcl_context_is_valid(const void * context);

extern "C" int rcl_publisher_get_subscription_count(const void * publisher, size_t * count)
{
  using Counts = int (*)(const void *, size_t *);
  static const Counts counts = reinterpret_cast<Counts>(dlsym(RTLD_NEXT, "rcl_publisher_get_subscription_count"));
  std::fputs("is asked\\n", stderr);
  while (rcl_context_is_valid(rcl_publisher_get_context(publisher))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return counts(publisher, count);
}
"""
"""A publisher that is asked for its subscriptions answers when its context was shut down."""
SHUTS_DOWN_SLOWLY = """#include <chrono>
#include <cstdio>
#include <dlfcn.h>
#include <thread>
#include <unistd.h>

namespace rclcpp::detail
{
struct Context
{
  bool shutdown();
  ~Context();
};

bool Context::shutdown()
{
  using Shuts = bool (*)(Context *);
  const bool done = reinterpret_cast<Shuts>(dlsym(RTLD_NEXT, "_ZN6rclcpp6detail7Context8shutdownEv"))(this);
  if (gettid() != getpid()) {
    std::this_thread::sleep_for(std::chrono::seconds(1));
    std::fputs("is shut down\\n", stderr);
  }
  return done;
}

Context::~Context()
{
  std::fputs("is destroyed\\n", stderr);
  using Destroys = void (*)(Context *);
  reinterpret_cast<Destroys>(dlsym(RTLD_NEXT, "_ZN6rclcpp6detail7ContextD1Ev"))(this);
}
}  // namespace rclcpp::detail
"""
"""The thread that shuts the context down on a signal is still at it when the main one has nothing more to do."""


@contextmanager
def running(preload, folder):
    """The node, with a library before those of rclcpp; the peer, and the log."""
    library, told = preloaded(preload, folder), folder / "told.txt"
    built = workspace()
    node = [built.prefix / "lib/eco_control" / NODES[NODE]]
    with own_domain() as number:
        own = variables(built, number, folder)
        with run_ros2.started([node], {**own, "LD_PRELOAD": str(library)}, told), peer(own) as other:
            yield other, told


def test_a_node_that_asks_who_listens_while_it_is_told_to_end(tmp_path):
    with running(ANSWERS_LATE, tmp_path) as (other, told):
        other.bring(NODE, CONFIGURE)
        wait_until(lambda: "is asked" in told.read_text(), "it asks")


def test_the_context_outlives_the_thread_that_a_signal_has_woken(tmp_path):
    with running(SHUTS_DOWN_SLOWLY, tmp_path) as (other, told):
        other.bring(NODE, CONFIGURE)
    assert [line for line in told.read_text().splitlines() if line.startswith("is ")] == [
        "is shut down",
        "is destroyed",
    ]
