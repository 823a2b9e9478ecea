# VOUSSOIR_ALONE: all libraries but that of C are linked in, for the wheel (scripts/package wheel). Sets what find_package would have found.
function(voussoir_static name file)
  find_library(VOUSSOIR_${name}_A ${file} PATH_SUFFIXES hdf5/serial REQUIRED)
  set(${name} ${VOUSSOIR_${name}_A} PARENT_SCOPE)
endfunction()
function(voussoir_of_gcc name file)
  execute_process(COMMAND ${CMAKE_CXX_COMPILER} -print-file-name=${file} OUTPUT_VARIABLE path OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT IS_ABSOLUTE ${path})
    message(FATAL_ERROR "${file} is not there; apt install gfortran")
  endif()
  set(${name} ${path} PARENT_SCOPE)
endfunction()

# HDF5 can read files in the network, by libcurl, which in turn needs some thirty libraries. It is told that there is no network.
add_library(no_network STATIC ${CMAKE_CURRENT_LIST_DIR}/no_network.c)
target_compile_options(no_network PRIVATE -march=x86-64)
foreach(library hdf5 sz aec z Clp CoinUtils lapack blas bz2)
  voussoir_static(static_${library} lib${library}.a)
endforeach()
foreach(library gomp gfortran quadmath)
  voussoir_of_gcc(static_${library} lib${library}.a)
endforeach()

find_path(VOUSSOIR_HDF5_HEADERS hdf5.h PATH_SUFFIXES hdf5/serial REQUIRED)
add_library(HDF5::HDF5 INTERFACE IMPORTED)
target_include_directories(HDF5::HDF5 INTERFACE ${VOUSSOIR_HDF5_HEADERS})
target_link_libraries(HDF5::HDF5 INTERFACE ${static_hdf5} ${static_sz} ${static_aec} ${static_z} no_network ${CMAKE_DL_LIBS} m)

add_library(ZLIB::ZLIB INTERFACE IMPORTED)
target_link_libraries(ZLIB::ZLIB INTERFACE ${static_z})

add_library(tomlplusplus::tomlplusplus INTERFACE IMPORTED)
target_compile_definitions(tomlplusplus::tomlplusplus INTERFACE TOML_HEADER_ONLY=1)

set(OpenMP_gomp_LIBRARY ${static_gomp})
set(CLP_LIBRARY ${static_Clp} ${static_CoinUtils} ${static_lapack} ${static_blas} ${static_gfortran} ${static_quadmath} ${static_bz2} ${static_z})
add_link_options(-static-libgcc -static-libstdc++)
