"""Software components for AUTOSAR Classic, and the test RTE that runs them."""
