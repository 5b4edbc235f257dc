#include "files/netcdf/netcdf_fields.h"

#include <fmt/format.h>
#include <netcdf.h>

#include <algorithm>
#include <charconv>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "files/atomic_file.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_form.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_piece.h"

namespace fumon {

namespace {

namespace fs = std::filesystem;

constexpr int piece_digits = 6;

fs::path piece_path(const fs::path& file, std::int64_t number) {
    fs::path piece = file;
    piece += fmt::format(".{:0{}}", number, piece_digits);
    return piece;
}

/// A closed file of records, of which the first `used` belong to the whole.
struct ClosedPiece {
    fs::path path;
    std::int64_t records = 0;
    std::int64_t used = 0;
};

[[noreturn]] void refuse_piece(const fs::path& piece, std::string_view why) {
    throw InputError(
        fmt::format("{}: cannot go on with it: {}; run the scene from its start with --force",
                    piece.string(), why));
}

std::int64_t records_of(const fs::path& piece) {
    const NetcdfLock lock;
    try {
        const NetcdfInput input(piece);
        int time = 0;
        check_netcdf(nc_inq_dimid(input.id(), "time", &time));
        return static_cast<std::int64_t>(input.dimension_length(time));
    } catch (const NetcdfFault& fault) {
        refuse_piece(piece, fault.what());
    }
}

}  // namespace

std::int64_t number_of_fields_piece(std::string_view name, std::string_view file) {
    if (!name.starts_with(file)) return 0;
    name.remove_prefix(file.size());
    if (!name.starts_with('.')) return 0;
    name.remove_prefix(1);
    std::int64_t number = 0;
    std::from_chars(name.data(), name.data() + name.size(), number);
    return number > 0 && fmt::format("{:0{}}", number, piece_digits) == name ? number : 0;
}

void remove_fields_pieces(const fs::path& file) {
    std::error_code fault;
    const fs::path folder = fs::absolute(file).parent_path();
    for (const auto& entry : fs::directory_iterator(folder, fault)) {
        const std::string name = entry.path().filename().string();
        if (number_of_fields_piece(name, file.filename().string()) > 0)
            fs::remove(entry.path(), fault);
    }
}

class FieldsFile::Parts {
  public:
    Parts(const fs::path& file, const Snapshot& first, FieldsText text)
        : file_(resolved_link(file)), outline_(outline_of(first)), text_(std::move(text)) {}

    void begin() { open_.emplace(file_, outline_, text_); }

    /// Finds what a former run left, and takes its first `records`.
    void go_on(std::int64_t records) {
        std::error_code fault;
        if (fs::exists(file_, fault)) {  // all pieces were joined
            remove_fields_pieces(file_);
            fs::rename(file_, piece_path(file_, 1), fault);
            if (fault) refuse_to_write(piece_path(file_, 1), fault.value());
        }
        while (total_ < records) {
            const fs::path path = piece_path(file_, next_number());
            if (!fs::exists(path, fault)) {
                throw InputError(fmt::format(
                    "{}: is not there; run the scene from its start with --force", path.string()));
            }
            const std::int64_t there = records_of(path);
            if (there == 0) refuse_piece(path, "it has no records");
            const std::int64_t used = std::min(there, records - total_);
            closed_.push_back({path, there, used});
            total_ += used;
        }
        for (std::int64_t later = next_number();; ++later) {  // that the checkpoint does not count
            if (!fs::remove(piece_path(file_, later), fault)) break;
        }
        fs::remove(temporary_name(file_), fault);
    }

    void add(const Snapshot& snapshot) {
        if (!open_) begin();
        open_->add(snapshot);
        ++total_;
    }

    void sync() {
        if (!open_ || open_->records() == 0) return;
        close_piece();
        sync_folder_of(file_);
    }

    void commit() {
        if (closed_.empty()) {
            if (open_) open_->close_as(file_);
            open_.reset();
            return;
        }
        if (open_ && open_->records() > 0) close_piece();
        open_.reset();
        if (closed_.size() == 1 && closed_.front().used == closed_.front().records) {
            if (std::rename(closed_.front().path.c_str(), file_.c_str()) != 0)
                refuse_to_write(file_, errno);
            return;
        }
        FieldsPiece whole(file_, outline_, text_);
        for (const ClosedPiece& piece : closed_) whole.copy(piece.path, piece.used);
        whole.close_as(file_);
        remove_fields_pieces(file_);
    }

    [[nodiscard]] std::int64_t records() const { return total_; }

  private:
    [[nodiscard]] std::int64_t next_number() const {
        return static_cast<std::int64_t>(closed_.size()) + 1;
    }

    void close_piece() {
        const std::int64_t records = open_->records();
        const fs::path path = piece_path(file_, next_number());
        open_->close_as(path);
        open_.reset();
        closed_.push_back({path, records, records});
    }

    fs::path file_;
    Snapshot outline_;
    FieldsText text_;
    std::vector<ClosedPiece> closed_;
    std::optional<FieldsPiece> open_;
    std::int64_t total_ = 0;
};

FieldsFile::FieldsFile(const fs::path& file, const Snapshot& first, const FieldsText& text) {
    check_whole(file, first);
    parts_ = std::make_unique<Parts>(file, first, text);
    parts_->begin();
}

FieldsFile::FieldsFile(const fs::path& file, const Snapshot& first, const FieldsText& text,
                       std::int64_t records)
    : parts_(std::make_unique<Parts>(file, first, text)) {
    parts_->go_on(records);
}

FieldsFile::~FieldsFile() = default;

void FieldsFile::add(const Snapshot& snapshot) {
    parts_->add(snapshot);
}

std::int64_t FieldsFile::records() const {
    return parts_->records();
}

void FieldsFile::sync() {
    parts_->sync();
}

void FieldsFile::commit() {
    parts_->commit();
}

}  // namespace fumon
