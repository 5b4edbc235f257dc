#include "run/terminal/job_watch.h"

#include <algorithm>
#include <thread>
#include <utility>

namespace fumon {

namespace {

constexpr std::chrono::seconds watched_for{4};  // after a client has asked
constexpr std::chrono::seconds least_interval{1};
constexpr std::chrono::seconds picture_interval{3};
constexpr std::chrono::seconds most_wait_at_end{10};
constexpr std::size_t most_messages = 100;
constexpr std::size_t most_clients = 256;
constexpr double seconds_for_a_second = 100.0;  // that pass for one of drawing

}  // namespace

void JobWatch::message(const std::string& line) {
    const std::lock_guard lock(mutex_);
    std::vector<std::string>& messages = state_.messages;
    if (messages.size() >= most_messages) messages.erase(messages.begin());
    messages.push_back(line);
}

void JobWatch::tell(std::vector<JobStage> stages, double seconds_left) {
    const std::lock_guard lock(mutex_);
    state_.stages = std::move(stages);
    state_.seconds_left = seconds_left;
}

bool JobWatch::is_watched() const {
    const auto now = Clock::now();
    return std::ranges::any_of(
        clients_, [&](const auto& client) { return now - client.second.asked < watched_for; });
}

bool JobWatch::has_clients() const {
    const std::lock_guard lock(mutex_);
    return is_watched();
}

bool JobWatch::wants_picture() const {
    const std::lock_guard lock(mutex_);
    return is_watched() && Clock::now() - shown_ >= picture_interval;
}

void JobWatch::show(std::shared_ptr<const Image> picture, std::string name) {
    const std::lock_guard lock(mutex_);
    picture_ = std::move(picture);
    state_.picture_name = std::move(name);
    ++state_.pictures;
    shown_ = Clock::now();
}

void JobWatch::take(std::shared_ptr<const Snapshot> snapshot) {
    const std::lock_guard lock(mutex_);
    snapshot_ = std::move(snapshot);
    wants_snapshot_ = false;
    next_drawing_ = std::max(next_drawing_, Clock::now() + least_interval);
}

void JobWatch::end(const std::string& outcome) {
    const auto latest = Clock::now() + most_wait_at_end;
    {
        const std::lock_guard lock(mutex_);
        state_.outcome = outcome;
        state_.seconds_left = 0.0;
        wants_snapshot_ = false;
    }
    constexpr std::chrono::milliseconds poll_interval{20};
    while (Clock::now() < latest && !all_have_heard()) std::this_thread::sleep_for(poll_interval);
}

bool JobWatch::all_have_heard() const {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    return std::ranges::all_of(clients_, [&](const auto& client) {
        return client.second.heard_of_end || now - client.second.asked > watched_for;
    });
}

JobState JobWatch::state(const std::string& client, bool is_last) {
    const std::lock_guard lock(mutex_);
    const auto now = Clock::now();
    if (clients_.size() >= most_clients) {
        std::erase_if(clients_,
                      [&](const auto& one) { return now - one.second.asked > watched_for; });
    }
    if (clients_.size() < most_clients || clients_.contains(client))
        clients_[client] = {now, is_last && !state_.outcome.empty()};
    return state_;
}

std::shared_ptr<const Image> JobWatch::picture() const {
    const std::lock_guard lock(mutex_);
    return picture_;
}

std::shared_ptr<const Snapshot> JobWatch::snapshot() const {
    const std::lock_guard lock(mutex_);
    return snapshot_;
}

bool JobWatch::may_draw() const {
    const std::lock_guard lock(mutex_);
    return Clock::now() >= next_drawing_;
}

void JobWatch::ask_for_snapshot() {
    const std::lock_guard lock(mutex_);
    if (state_.outcome.empty() && Clock::now() >= next_drawing_) wants_snapshot_ = true;
}

void JobWatch::spend(double seconds) {
    const std::lock_guard lock(mutex_);
    const std::chrono::duration<double> pause(seconds * seconds_for_a_second);
    const auto from = std::max(next_drawing_, Clock::now());
    next_drawing_ = from + std::chrono::duration_cast<Clock::duration>(pause);
}

}  // namespace fumon
