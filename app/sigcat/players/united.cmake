# What rosidl generates in C++ is compiled in few large units instead of many small ones, in half the time. Introspection in C++ is not:
# a message that holds another one instantiates what the unit of that one specializes, which must not come later in the same unit.
if(CMAKE_VERSION VERSION_GREATER_EQUAL 3.19)
  cmake_language(DEFER CALL unite_generated)
endif()
function(unite_generated)
  get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target IN LISTS targets)
    if(target MATCHES "__rosidl_typesupport_((fastrtps_)?(c|cpp)|introspection_c)$")
      set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 100)
    endif()
  endforeach()
endfunction()
