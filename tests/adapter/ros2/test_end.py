"""A node that is told to end does so with status 0, whatever it is doing."""

from scripts import run_ros2
from sigcat.players.ros2_domain import own_domain
from tests.adapter.ros2.built import NODES, preloaded, variables, workspace
from tests.adapter.ros2.other_end import CONFIGURE, peer
from tests.needs import ros2
from tests.waiting import wait_until

pytestmark = ros2

NODE = "core_acc"
WAITS = """#include <chrono>
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


def test_a_node_that_asks_who_listens_while_it_is_told_to_end(tmp_path):
    library, told = preloaded(WAITS, tmp_path), tmp_path / "told.txt"
    built = workspace()
    node = [built.prefix / "lib/eco_control" / NODES[NODE]]
    with own_domain() as number:
        own = variables(built, number, tmp_path)
        with run_ros2.started([node], {**own, "LD_PRELOAD": str(library)}, told), peer(own) as other:
            other.bring(NODE, CONFIGURE)
            wait_until(lambda: "is asked" in told.read_text(), "it asks")
