# The functions that scenes use stand beside each other in a program (tools/link_order): scattered over its twelve megabytes, they bring six of them
# into memory, together three. verisim_link_order(TARGET); nothing where the linker does not know how.
string(APPEND CMAKE_CXX_FLAGS " -ffunction-sections")

set(link_order_list ${PROJECT_SOURCE_DIR}/tools/link_order/functions.txt)
set(VERISIM_LINK_ORDER ${PROJECT_BINARY_DIR}/link_order.ld)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${link_order_list})
file(STRINGS ${link_order_list} link_order_functions)
list(JOIN link_order_functions ")\n    *(.text." link_order_sections)
file(CONFIGURE OUTPUT ${VERISIM_LINK_ORDER} @ONLY CONTENT "SECTIONS {
  .text.common : {
    *(.text.@link_order_sections@)
  }
}
INSERT BEFORE .text;
")

include(CheckLinkerFlag)
check_linker_flag(CXX "-Wl,-T,${VERISIM_LINK_ORDER}" VERISIM_HAS_LINK_ORDER)
function(verisim_link_order name)
  if(VERISIM_HAS_LINK_ORDER)
    target_link_options(${name} PRIVATE -Wl,-T,${VERISIM_LINK_ORDER})
    set_property(TARGET ${name} APPEND PROPERTY LINK_DEPENDS ${VERISIM_LINK_ORDER})
  endif()
endfunction()
