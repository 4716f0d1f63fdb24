# Parallel compile jobs are bounded by memory, whatever `ninja -j` says: a file takes up to a gigabyte and a half.
set(gibench_job_mib 1536)

cmake_host_system_information(RESULT gibench_memory_mib QUERY TOTAL_PHYSICAL_MEMORY)
# A container may have less than the machine: control groups of version 2, and of version 1.
foreach(gibench_limit_file IN ITEMS /sys/fs/cgroup/memory.max /sys/fs/cgroup/memory/memory.limit_in_bytes)
  if(EXISTS ${gibench_limit_file})
    file(READ ${gibench_limit_file} gibench_limit)
    if(gibench_limit MATCHES "^[0-9]+")  # not the word "max"
      math(EXPR gibench_limit "${CMAKE_MATCH_0} / 1048576")
      if(gibench_limit LESS gibench_memory_mib)
        set(gibench_memory_mib ${gibench_limit})
      endif()
    endif()
  endif()
endforeach()
math(EXPR gibench_jobs "${gibench_memory_mib} / ${gibench_job_mib}")
if(gibench_jobs LESS 1)
  set(gibench_jobs 1)
endif()
set_property(GLOBAL PROPERTY JOB_POOLS memory=${gibench_jobs})
set(CMAKE_JOB_POOL_COMPILE memory)
set(CMAKE_JOB_POOL_LINK memory)
message(STATUS "At most ${gibench_jobs} files are compiled at a time (${gibench_memory_mib} MiB of memory)")
