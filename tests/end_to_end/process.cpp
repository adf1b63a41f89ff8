#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "tests/end_to_end/x11_driver.h"

namespace guidelight {
namespace {

using namespace std::chrono_literals;

/// Starts a program that dies with this process; `stream` goes to a file unless its name is empty.
/// Returns its process id.
pid_t start_program(const std::vector<std::string>& command,
                    const std::vector<std::string>& environment, const std::string& folder,
                    const std::string& output, int stream) {
  std::vector<char*> arguments;
  for (const std::string& word : command) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  const pid_t pid = fork();
  if (pid != 0) return pid;
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  for (const std::string& variable : environment) putenv(const_cast<char*>(variable.c_str()));
  if (!output.empty()) dup2(open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644), stream);
  if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

void end_program(pid_t pid) {
  kill(pid, SIGKILL);
  waitpid(pid, nullptr, 0);
}

/// The display number that Xvfb writes when it is ready; empty if it does not.
std::string read_display_number(int descriptor) {
  std::string number;
  pollfd ready{descriptor, POLLIN, 0};
  while (poll(&ready, 1, 10'000) > 0) {
    char byte = 0;
    if (read(descriptor, &byte, 1) != 1 || byte == '\n') break;
    number += byte;
  }
  return number;
}

}  // namespace

bool wait_until(const std::function<bool()>& condition, std::chrono::milliseconds longest) {
  const auto end = std::chrono::steady_clock::now() + longest;
  do {
    if (condition()) return true;
    std::this_thread::sleep_for(20ms);
  } while (std::chrono::steady_clock::now() < end);
  return condition();
}

ChildProcess::ChildProcess(const std::vector<std::string>& command,
                           const std::vector<std::string>& environment, const std::string& folder,
                           const std::string& output)
    : pid_(start_program(command, environment, folder, output, STDOUT_FILENO)) {}

ChildProcess::~ChildProcess() {
  if (!status_) end_program(pid_);
}

std::optional<int> ChildProcess::wait(std::chrono::milliseconds longest) {
  wait_until(
      [&] {
        int status = 0;
        if (!status_ && waitpid(pid_, &status, WNOHANG) == pid_) {
          status_ = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
        }
        return status_.has_value();
      },
      longest);
  return status_;
}

/// Fields 14 and 15 of /proc/PID/stat, user and system time; the second field may hold spaces.
double ChildProcess::cpu_seconds() const {
  std::ifstream file("/proc/" + std::to_string(pid_) + "/stat");
  std::string line;
  std::getline(file, line);
  std::istringstream fields(line.substr(line.rfind(')') + 2));
  std::string skipped;
  for (int field = 3; field < 14; ++field) fields >> skipped;
  double user = 0, system = 0;
  fields >> user >> system;
  return (user + system) / static_cast<double>(sysconf(_SC_CLK_TCK));
}

/// The second field of /proc/PID/statm, in pages.
size_t ChildProcess::resident_bytes() const {
  std::ifstream file("/proc/" + std::to_string(pid_) + "/statm");
  size_t pages = 0;
  file >> pages >> pages;
  return pages * static_cast<size_t>(sysconf(_SC_PAGESIZE));
}

std::unique_ptr<VirtualDisplay> VirtualDisplay::start(int width, int height) {
  int ends[2];
  if (pipe(ends) != 0) return nullptr;
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const std::string screen = std::to_string(width) + "x" + std::to_string(height) + "x24";
  const pid_t pid = start_program({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                                   screen, "-nolisten", "tcp", "-noreset"},
                                  {}, "", "/dev/null", STDERR_FILENO);
  close(ends[1]);
  const std::string number = read_display_number(ends[0]);
  close(ends[0]);
  if (number.empty()) {
    end_program(pid);
    return nullptr;
  }
  return std::unique_ptr<VirtualDisplay>(new VirtualDisplay(":" + number, pid));
}

VirtualDisplay::~VirtualDisplay() { end_program(pid_); }

}  // namespace guidelight
