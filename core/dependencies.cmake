# The libraries that the core links. Read when it is built, and by whoever links it once it is
# installed (this file lies beside voxpriteConfig.cmake then).
find_package(GIF REQUIRED)
find_package(glm REQUIRED)
find_package(TBB REQUIRED)
find_package(OpenSSL REQUIRED COMPONENTS Crypto)
find_package(ZLIB REQUIRED)
find_package(PkgConfig REQUIRED)
pkg_check_modules(LIBZIP REQUIRED IMPORTED_TARGET libzip)
pkg_check_modules(STB REQUIRED IMPORTED_TARGET stb)
pkg_check_modules(HWY REQUIRED IMPORTED_TARGET libhwy)

# voxprite_library(name header library...): voxprite::name, for libraries that bring no package of
# their own, or one that wants more than the library (OpenVDB's).
function(voxprite_library name header)
  if(TARGET voxprite::${name})
    return()
  endif()
  find_path(VOXPRITE_${name}_INCLUDE ${header} REQUIRED)
  find_library(VOXPRITE_${name}_LIBRARY NAMES ${ARGN} REQUIRED)
  mark_as_advanced(VOXPRITE_${name}_INCLUDE VOXPRITE_${name}_LIBRARY)
  add_library(voxprite::${name} UNKNOWN IMPORTED)
  set_target_properties(
    voxprite::${name} PROPERTIES IMPORTED_LOCATION ${VOXPRITE_${name}_LIBRARY}
                                 INTERFACE_INCLUDE_DIRECTORIES ${VOXPRITE_${name}_INCLUDE})
endfunction()
voxprite_library(openvdb openvdb/openvdb.h openvdb)
voxprite_library(imath Imath/half.h Imath Imath-3_1)
voxprite_library(meshoptimizer meshoptimizer.h meshoptimizer)
