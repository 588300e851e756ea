get_property(lines GLOBAL PROPERTY rclcpp_components_lines)
set(file "${CMAKE_CURRENT_BINARY_DIR}/rclcpp_components_of_${PROJECT_NAME}")
file(GENERATE OUTPUT ${file} CONTENT "${lines}")
install(FILES ${file} DESTINATION share/ament_index/resource_index/rclcpp_components RENAME ${PROJECT_NAME})
