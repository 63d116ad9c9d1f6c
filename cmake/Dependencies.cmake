# Everything comes from Debian 12 packages; ./test and ./demo install them.
find_package(Threads REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(Imath REQUIRED)
find_package(embree 3 REQUIRED)
find_package(TBB REQUIRED)
find_package(fmt REQUIRED)
find_package(PNG REQUIRED)
find_package(Freetype REQUIRED)
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
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)  # manifests
find_package(OpenSSL REQUIRED COMPONENTS Crypto)  # SHA-256, the key of the oracle's cache
if(VERISIM_TESTS)
  find_package(GTest REQUIRED)
endif()
