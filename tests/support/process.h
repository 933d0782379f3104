// Programs that tests run beside themselves, and an X server without a screen for those that need
// one.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <glm/vec2.hpp>
#include <string>
#include <vector>

namespace voxprite::test {

// A child process, killed when this goes.
class Process {
  public:
    Process() = default;
    Process(const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
            const std::filesystem::path& output, int inheritedDescriptor = -1);
    ~Process();
    Process(const Process&) = delete;
    Process& operator=(Process&& other) noexcept;
    [[nodiscard]] bool running();
    void kill();  // without a chance to tidy up
    // Its exit status once it has ended by itself; -1 when it crashed or took longer. Generous, for
    // a busy machine is no failure.
    [[nodiscard]] int wait(std::chrono::seconds longest = std::chrono::seconds(90));

  private:
    pid_t id_ = -1;
    int status_ = -1;
};

// Xvfb on a number of its own choice.
class VirtualDisplay {
  public:
    // Fails the test when it does not start. Its log is put into `folder`.
    void start(glm::ivec2 screenPx, const std::filesystem::path& folder);
    [[nodiscard]] const std::string& name() const { return name_; }  // for DISPLAY

  private:
    std::string name_;
    Process server_;
};

// The whole file; empty when there is none.
[[nodiscard]] std::string contentOf(const std::filesystem::path& path);

}  // namespace voxprite::test
