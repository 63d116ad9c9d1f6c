# Everything comes from Debian 12 packages; ./test and ./demo install them.
find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(Imath REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
# OpenImageIO pulls some 260 shared libraries in, 0.2 s of start-up: only the image module links it (tracer/image/module).
find_package(OpenImageIO REQUIRED)
# Debian's package names include folders of optional packages that need not be installed; CMake refuses those.
get_target_property(oiio_includes OpenImageIO::OpenImageIO INTERFACE_INCLUDE_DIRECTORIES)
set(oiio_existing_includes)
foreach(folder IN LISTS oiio_includes)
  if(EXISTS "${folder}")
    list(APPEND oiio_existing_includes "${folder}")
  endif()
endforeach()
set_target_properties(OpenImageIO::OpenImageIO PROPERTIES INTERFACE_INCLUDE_DIRECTORIES "${oiio_existing_includes}")
# Google Highway, SIMD for every compiler and machine (tracer/simd): its headers only.
find_path(VERISIM_HWY_INCLUDE_DIR hwy/highway.h REQUIRED DOC "Folder of Google Highway")
# An assembler for native code of user functions (tracer/functions/machine_code.cpp): its headers only. Other processors interpret.
if(CMAKE_SYSTEM_PROCESSOR STREQUAL "x86_64")
  find_path(VERISIM_XBYAK_INCLUDE_DIR xbyak/xbyak.h REQUIRED DOC "Folder of xbyak")
endif()
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_path(VERISIM_SECCOMP_INCLUDE_DIR seccomp.h REQUIRED DOC "Folder of libseccomp, whose header has the numbers of system calls (cli/sandbox); used without its library")
find_path(VERISIM_TOML_INCLUDE_DIR toml++/toml.h REQUIRED DOC "Folder of toml++, which reads manifests; used without its library")
# A picture of a small scene takes a few milliseconds, and every shared library costs some of that at each start: archives where there are any.
set(shared_suffixes ${CMAKE_FIND_LIBRARY_SUFFIXES})
list(PREPEND CMAKE_FIND_LIBRARY_SUFFIXES .a)
find_package(PNG REQUIRED)
find_package(JPEG REQUIRED)
find_package(GIF 5 REQUIRED)
list(APPEND CMAKE_MODULE_PATH ${CMAKE_CURRENT_LIST_DIR})
find_package(Deflate REQUIRED)
set(OPENSSL_USE_STATIC_LIBS ON)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)  # SHA-256, the key of the oracle's cache
set(CMAKE_FIND_LIBRARY_SUFFIXES ${shared_suffixes})
# Linked by plug-ins only (tracer/image/module). After the archives: OpenEXR looks for zlib, too.
find_package(TIFF 4.5 REQUIRED)
find_package(OpenEXR REQUIRED)
if(VERISIM_TESTS)
  find_package(GTest REQUIRED)
endif()
