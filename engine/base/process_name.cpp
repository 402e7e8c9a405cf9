#include "engine/base/process_name.hpp"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <climits>
#include <cstring>
#include <fstream>
#include <iterator>

namespace rift::base {

std::string host_name() {
  std::array<char, HOST_NAME_MAX + 1> name{};
  if (::gethostname(name.data(), name.size() - 1) != 0) return "host";
  std::string host(name.data(), std::find(name.begin(), name.end(), '.') - name.begin());
  host.resize(std::strlen(host.c_str()));
  for (char& c : host)
    if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '_';
  return host.empty() ? "host" : host;
}

bool has_ended(pid_t process) {
  if (::kill(process, 0) != 0) return errno == ESRCH;
  std::ifstream status(fmt::format("/proc/{}/stat", process));
  const std::string text{std::istreambuf_iterator<char>(status), {}};
  const std::size_t name_end = text.rfind(')');  // "PID (NAME) STATE ..."
  return name_end != text.npos && name_end + 2 < text.size() &&
         (text[name_end + 2] == 'Z' || text[name_end + 2] == 'X');
}

}  // namespace rift::base
