# Flags and helpers shared by every target.

add_library(verisim_flags INTERFACE)
target_compile_options(verisim_flags INTERFACE
  # Clang's -Wshadow counts names of friends and fields, too.
  -Wall -Wextra -Wpedantic $<$<CXX_COMPILER_ID:GNU>:-Wshadow> -Wnon-virtual-dtor -Werror
  # Coincident faces and tight thresholds must fall as in plain IEEE double arithmetic on every machine.
  -ffp-contract=off)
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  # GCC 12's SLP vectoriser drops roundings: two neighbouring double -> float -> double conversions become none (tracer/math/rounding_test.cpp).
  target_compile_options(verisim_flags INTERFACE -fno-tree-slp-vectorize)
  # GCC 12 reports these inside its own library headers when it inlines.
  target_compile_options(verisim_flags INTERFACE -Wno-maybe-uninitialized -Wno-stringop-overflow -Wno-array-bounds -Wno-dangling-pointer -Wno-restrict)
  # What GCC 12 does for some average processor costs ours dearly. It copies structs of wide registers by halves: whoever reads them whole waits until both are in the cache, some twenty cycles.
  # (Code for smaller registers stays as it is.) And it clears a hundred bytes by `rep stos`, which takes thirty cycles to begin.
  include(CheckCXXCompilerFlag)
  foreach(flags "-mmove-max=256;-mstore-max=256" "-mmemset-strategy=unrolled_loop:256:noalign,libcall:-1:noalign")
    string(MAKE_C_IDENTIFIER "VERISIM_HAS_${flags}" has)
    string(REPLACE ";" " " together "${flags}")
    check_cxx_compiler_flag("${together}" ${has})
    if(${has})
      target_compile_options(verisim_flags INTERFACE ${flags})
    endif()
  endforeach()
else()
  target_compile_options(verisim_flags INTERFACE -Wno-psabi)  # wide vectors are passed only between functions of one file
  target_compile_options(verisim_flags INTERFACE -Wno-bitwise-instead-of-logical)  # where a branch would cost more
endif()
# More optimisation than the build type has, for single sources.
set(VERISIM_HOT -O3)
if(VERISIM_SANITIZE)
  # A sanitized build has to be affordable, or nobody makes it. Checks of each pointer for null, alignment and the size of what it points to double the time of compilation; a null pointer
  # shows without them, too. In kernels, where all is inlined, undefined behaviour alone would cost a minute a file.
  set(VERISIM_HOT "")
  set(cheaper "")
  if(VERISIM_SANITIZE MATCHES "undefined")
    set(cheaper -fno-sanitize=null,alignment,object-size,vptr,pointer-overflow,nonnull-attribute,returns-nonnull-attribute)
    set(VERISIM_KERNELS_SANITIZE -fno-sanitize=undefined)
  endif()
  target_compile_options(verisim_flags INTERFACE -fsanitize=${VERISIM_SANITIZE} ${cheaper} -fno-omit-frame-pointer -g1)
  target_link_options(verisim_flags INTERFACE -fsanitize=${VERISIM_SANITIZE})
endif()
if(VERISIM_FUZZ AND CMAKE_CXX_COMPILER_ID MATCHES "Clang")
  target_compile_options(verisim_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()

# A program at an address of its own each time (PIE), with nothing to write to that decides about calls (full RELRO). Its 37,000 addresses are
# relocated in 0.3 ms at each start; packed, where the linker can do that, they take 7 kB of the file instead of 500.
include(CheckLinkerFlag)
check_linker_flag(CXX "-Wl,-z,pack-relative-relocs" VERISIM_HAS_PACKED_RELOCATIONS)
function(verisim_hardened_link name)
  target_link_options(${name} PRIVATE -pie -Wl,-z,relro,-z,now,-z,noexecstack $<$<BOOL:${VERISIM_HAS_PACKED_RELOCATIONS}>:-Wl,-z,pack-relative-relocs>)
endfunction()
# What the compiler adds against mistakes: looks at the stack before a function returns, at sizes in calls of the C library, at where jumps
# land. The sanitizers look at more.
if(VERISIM_HARDEN AND NOT VERISIM_SANITIZE)
  include(CheckCXXCompilerFlag)
  check_cxx_compiler_flag(-fcf-protection VERISIM_HAS_CF_PROTECTION)  # x86
  set(CMAKE_REQUIRED_FLAGS -Werror)  # Clang takes it for any processor, and warns
  check_cxx_compiler_flag(-mbranch-protection=standard VERISIM_HAS_BRANCH_PROTECTION)  # aarch64
  unset(CMAKE_REQUIRED_FLAGS)
  target_compile_options(verisim_flags INTERFACE -fstack-protector-strong $<$<BOOL:${VERISIM_HAS_CF_PROTECTION}>:-fcf-protection>
                                                 $<$<BOOL:${VERISIM_HAS_BRANCH_PROTECTION}>:-mbranch-protection=standard>)
  target_compile_options(verisim_flags INTERFACE $<$<NOT:$<CONFIG:Debug>>:-U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2>)
endif()

# Looks at the bounds of containers, too: in all but the tracer, whose inner loops pay too much for it.
function(verisim_checked_containers target)
  if(VERISIM_HARDEN)
    target_compile_definitions(${target} PRIVATE _GLIBCXX_ASSERTIONS)
  endif()
endfunction()

# verisim_precompile(TARGET HEADER): the header (named from the root) is compiled once and stands before each source, which saves two thirds of
# the time of most. In angle brackets CMake writes it as it is, so that a compiler cache serves all trees.
function(verisim_precompile target header)
  target_precompile_headers(${target} PRIVATE <${header}>)
  # Options of a source's own would make it another header.
  get_target_property(sources ${target} SOURCES)
  foreach(source ${sources})
    get_source_file_property(options ${source} COMPILE_OPTIONS)
    if(options)
      set_source_files_properties(${source} PROPERTIES SKIP_PRECOMPILE_HEADERS ON)
    endif()
  endforeach()
endfunction()

# verisim_units(TARGET): with VERISIM_UNITS, its sources are compiled eight at a time, so that headers and templates that many of them use are compiled once
# for all eight. Names in unnamed namespaces must differ within a library then: a name that two files of it want is mostly one function that stands twice.
# Kernels and other sources with options of their own stay alone.
function(verisim_units target)
  if(VERISIM_UNITS)
    set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
    # A source that is included looks like a header to GCC, where a type of no linkage as a member would be a mistake.
    target_compile_options(${target} PRIVATE $<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>)
  endif()
endfunction()

# verisim_library(NAME): a library from all sources below the current folder; *_test.cpp beside the code become NAME_tests.
function(verisim_library name)
  file(GLOB_RECURSE sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*.cpp)
  list(FILTER sources EXCLUDE REGEX "_test\\.cpp$|/module/|/tools/")
  if(NOT sources)  # a layer that only has headers so far
    file(WRITE ${CMAKE_CURRENT_BINARY_DIR}/${name}_empty.cpp "")
    set(sources ${CMAKE_CURRENT_BINARY_DIR}/${name}_empty.cpp)
  endif()
  add_library(${name} STATIC ${sources})
  add_library(verisim::${name} ALIAS ${name})
  target_include_directories(${name} PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}>
                             $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}> $<INSTALL_INTERFACE:${CMAKE_INSTALL_INCLUDEDIR}/verisim>)
  target_compile_features(${name} PUBLIC cxx_std_20)
  target_link_libraries(${name} PRIVATE $<BUILD_INTERFACE:verisim_flags>)
  verisim_units(${name})
endfunction()

function(verisim_tests name)
  if(NOT VERISIM_TESTS)
    return()
  endif()
  file(GLOB_RECURSE tests CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/*_test.cpp)
  if(NOT tests)
    return()
  endif()
  add_executable(${name} ${tests})
  verisim_units(${name})
  target_link_libraries(${name} PRIVATE verisim_flags GTest::gmock GTest::gtest_main ${ARGN})
  if("${ARGN}" MATCHES "verisim_(tracer|parser|compare|cli)")  # not those of tools
    verisim_precompile(${name} tests/precompiled.h)
  endif()
  include(GoogleTest)
  # Only the tests that ask for a place in the tree are compiled with it, so that a compiler cache serves all others in any tree.
  foreach(test ${tests})
    file(STRINGS ${test} asks REGEX "VERISIM_(SOURCE|BINARY)_DIR" LIMIT_COUNT 1)
    if(asks)
      set_source_files_properties(${test} PROPERTIES COMPILE_DEFINITIONS
                                  "VERISIM_SOURCE_DIR=\"${PROJECT_SOURCE_DIR}\";VERISIM_BINARY_DIR=\"${PROJECT_BINARY_DIR}\"")
    endif()
  endforeach()
  set(environment "")
  if(VERISIM_SANITIZE MATCHES "thread")
    set(environment ENVIRONMENT "TSAN_OPTIONS=suppressions=${PROJECT_SOURCE_DIR}/tools/tsan.supp")
  elseif(VERISIM_SANITIZE MATCHES "address")
    # GCC 12's leak check crashes now and then where threads of loaded libraries are just ending; without this it does not.
    set(environment ENVIRONMENT "ASAN_OPTIONS=intercept_tls_get_addr=0")
  endif()
  # What takes long has Slow at the start of its name and the label of that name.
  gtest_discover_tests(${name} TEST_FILTER "-*.Slow*" DISCOVERY_TIMEOUT 120 PROPERTIES TIMEOUT 600 ${environment})
  gtest_discover_tests(${name} TEST_FILTER "*.Slow*" TEST_LIST ${name}_slow DISCOVERY_TIMEOUT 120 PROPERTIES LABELS slow TIMEOUT 3000 ${environment})
endfunction()
