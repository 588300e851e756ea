include(CMakeFindDependencyMacro)
find_dependency(rclcpp)
include(${CMAKE_CURRENT_LIST_DIR}/rclcpp_componentsTargets.cmake)
set(rclcpp_components_TARGETS rclcpp_components::component)

# Registers classes of a library: `ament_package` writes them into the index.
function(rclcpp_components_register_nodes target)
  foreach(class ${ARGN})
    set_property(GLOBAL APPEND_STRING PROPERTY rclcpp_components_lines "${class};lib/$<TARGET_FILE_NAME:${target}>\n")
  endforeach()
endfunction()

if(COMMAND ament_register_extension)
  ament_register_extension("ament_package" "rclcpp_components" "register.cmake")
endif()
