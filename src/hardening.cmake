# What distributions compile and link programs with: buffers whose sizes are known are checked when they are written to, a
# function with buffers sees when its return address was overwritten, the program lies anywhere in memory, and the table of
# functions that it calls in libraries is read-only. No number depends on any of it.
include(CheckPIESupported)
check_pie_supported(LANGUAGES CXX)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
target_compile_options(fumon_options INTERFACE -U_FORTIFY_SOURCE -D_FORTIFY_SOURCE=2 -fstack-protector-strong -Wformat
                       -Werror=format-security)
if(CMAKE_SYSTEM_NAME STREQUAL "Linux")
    target_link_options(fumon_options INTERFACE LINKER:-z,relro,-z,now)
endif()
