// A handler may call little more than write(): all text is ready before, and a verdict is written beside and renamed as
// everywhere, but by system calls alone.
#include "hatchway/plugin_host/trial/crash_watch.hpp"

#include <fcntl.h>
#include <signal.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <list>
#include <utility>

#include "hatchway/core/plain_text.hpp"
#include "hatchway/plugin_host/trial/endings.hpp"
#include "hatchway/plugin_host/trial/library_verdicts.hpp"

namespace hw {
namespace {

constexpr int kBadPlugin = 2;  // the exit code of bad input
constexpr std::size_t kStackBytes = 1 << 16;

constexpr const char* kExited = "it ended the program by exit()";

std::list<WatchedPlugin>& watched()
{
    static auto* const plugins = new std::list<WatchedPlugin>;  // outlives what runs at exit
    return *plugins;
}

std::atomic<const PluginCall*> current_call{nullptr};
std::array<struct sigaction, kEndings.size()> before;

/// Text put together without allocation; what does not fit is cut off.
class SignalText {
 public:
    SignalText& add(const char* text)
    {
        for (; *text != '\0' && size_ < bytes_.size(); ++text) bytes_[size_++] = *text;
        return *this;
    }
    bool write_to(int file) const { return ::write(file, bytes_.data(), size_) == static_cast<ssize_t>(size_); }
    const char* c_str()
    {
        bytes_[std::min(size_, bytes_.size() - 1)] = '\0';
        return bytes_.data();
    }

 private:
    std::array<char, 1024> bytes_;
    std::size_t size_ = 0;
};

}  // namespace

struct CrashNote {
    /// Writes what happened in the current call, once; false when there is none.
    static bool write(const char* what)
    {
        const PluginCall* call = current_call;
        if (call == nullptr || call->thread_ != ::gettid()) return false;
        current_call = nullptr;
        const WatchedPlugin& plugin = *call->plugin_;
        SignalText told;
        told.add("hatchway: error: the plugin \"")
            .add(plugin.name.c_str())
            .add("\": ")
            .add(what)
            .add(call->text_.data());
        told.add(plugin.folder < 0 ? "\n" : "; the next start leaves it out\n");
        told.write_to(STDERR_FILENO);
        if (plugin.folder >= 0) write_verdict(plugin, what, call->text_.data());
        return true;
    }
    static void write_verdict(const WatchedPlugin& plugin, const char* what, const char* where)
    {
        SignalText beside;
        beside.add(".hatchway-").add(plugin.key.c_str()).add(".tmp");
        const int file = ::openat(plugin.folder, beside.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_NOFOLLOW, 0600);
        SignalText text;
        text.add(LibraryVerdicts::kRefused).add(what).add(where).add(" when it was used last");
        if (file >= 0 && text.write_to(file) && ::fsync(file) == 0)
            ::renameat(plugin.folder, beside.c_str(), plugin.folder, plugin.key.c_str());
    }
};

namespace {

void on_crash(int signal, siginfo_t* info, void*)
{
    // One that another process sent says nothing about the plugin.
    const bool is_sent = info->si_code <= 0 && info->si_pid != ::getpid();
    if (!is_sent) CrashNote::write(ending_by(signal));
    for (std::size_t i = 0; i < kEndings.size(); ++i)
        if (kEndings[i].signal == signal) ::sigaction(signal, &before[i], nullptr);
    ::raise(signal);  // arrives when this returns
}

void on_exit()
{
    if (CrashNote::write(kExited)) ::_exit(kBadPlugin);
}

void install_handlers()
{
    // A recursion without end leaves no room on the usual stack.
    static std::array<char, kStackBytes> stack;
    const stack_t own{.ss_sp = stack.data(), .ss_flags = 0, .ss_size = stack.size()};
    ::sigaltstack(&own, nullptr);
    struct sigaction action = {};
    action.sa_sigaction = on_crash;
    action.sa_flags = SA_SIGINFO | SA_ONSTACK;
    for (std::size_t i = 0; i < kEndings.size(); ++i) ::sigaction(kEndings[i].signal, &action, &before[i]);
    std::atexit(on_exit);
}

}  // namespace

void watch_plugin(WatchedPlugin plugin)
{
    if (watched().empty()) install_handlers();
    if (plugin.folder >= 0) plugin.folder = ::fcntl(plugin.folder, F_DUPFD_CLOEXEC, 0);  // open to the end
    watched().push_front(std::move(plugin));
}

bool PluginCall::is_watching()
{
    return !watched().empty();
}

PluginCall::PluginCall(std::string_view plugin, std::string_view doing, std::string_view drawn)
{
    if (!is_watching()) return;
    const auto found = std::find_if(watched().begin(), watched().end(),
                                    [&](const WatchedPlugin& each) { return each.name == plugin; });
    const PluginCall* outer = current_call;
    if (found == watched().end() || (outer != nullptr && outer->plugin_ == &*found)) return;
    plugin_ = &*found;
    thread_ = ::gettid();
    const std::string object = drawn.empty() ? "" : ", drawing " + plain_text(drawn);
    std::snprintf(text_.data(), text_.size(), " in %.*s%s", static_cast<int>(doing.size()), doing.data(),
                  object.c_str());
    outer_ = current_call.exchange(this);
}

PluginCall::~PluginCall()
{
    if (plugin_ != nullptr) current_call = outer_;
}

}  // namespace hw
