// The system calls that are left to the process (seccomp): files that are named or open, memory,
// threads, time. All others fail with EPERM: no sockets are made, no processes, no programs run, nothing is traced.
#pragma once

namespace verisim::cli {

// False: the kernel has no filters, or a container refuses them.
bool has_system_call_filters();

// For all threads of the process. `server`: it may answer on sockets that listen already. Throws std::runtime_error.
void restrict_system_calls(bool server);

}  // namespace verisim::cli
