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
#include "files/netcdf/netcdf_copy.h"
#include "files/netcdf/netcdf_form.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_piece.h"
#include "files/netcdf/netcdf_values.h"

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

/// What a former run left, as far as it is what the run wrote.
struct LeftPieces {
    std::vector<ClosedPiece> pieces;
    FieldsDifference difference;
};

/// The variables of a file as it would be made, held in memory alone.
FieldsLayout layout_of(const Snapshot& first) {
    int scratch = -1;
    check_netcdf(nc_create("fields", NC_NETCDF4 | NC_DISKLESS, &scratch));
    const struct Closed {
        int file;
        ~Closed() { nc_abort(file); }
    } at_end{scratch};
    return define_fields(scratch, first, {});
}

/// Reads the first records, at most `most`, of a file; returns how many it has. Throws NetcdfFault
/// and InputError.
std::int64_t read_records(const fs::path& file, std::int64_t most, const Snapshot& first,
                          Sha256Stream& hash) {
    const FieldsLayout layout = layout_of(first);
    const NetcdfInput input(file);
    const RecordForm form = record_form(first);
    const SourceVariables source = source_variables(input, form.fields, form.numbers);
    const std::vector<int> over = input.dimensions(source.time);
    const std::size_t there = over.size() == 1 ? input.dimension_length(over.front()) : 0;
    RecordValues values(std::nullopt, hash);
    for (std::size_t record = 0; record < there && std::cmp_less(record, most); ++record)
        copy_record(input, source, record, values, layout, first.bed.nx(), first.bed.ny(), record);
    return static_cast<std::int64_t>(there);
}

/// Why a file cannot be read; empty where it can. `records`: how many it has.
std::string read_piece(const fs::path& file, std::int64_t most, const Snapshot& first,
                       Sha256Stream& hash, std::int64_t& records) {
    std::error_code fault;
    if (!fs::exists(file, fault)) return "does not exist";
    if (!fs::is_regular_file(file, fault)) return "is not a file";
    const NetcdfLock lock;
    try {
        records = read_records(file, most, first, hash);
        return records == 0 ? "has no records" : "";
    } catch (const NetcdfFault& unreadable) {
        return fmt::format("cannot be read: {}", unreadable.what());
    } catch (const InputError& unreadable) {
        return fmt::format("cannot be read: {}", unreadable.what());
    }
}

/// A file under its own name holds all pieces, of which some may be left beside it.
LeftPieces find_pieces(const fs::path& file, const Snapshot& first,
                       const FieldsBeginning& beginning, Sha256Stream& hash) {
    LeftPieces left;
    std::int64_t total = 0;
    std::error_code fault;
    const bool is_joined = fs::exists(fs::symlink_status(file, fault));
    while (total < beginning.records) {
        const auto next = static_cast<std::int64_t>(left.pieces.size()) + 1;
        const fs::path path = is_joined ? file : piece_path(file, next);
        const std::int64_t wanted = beginning.records - total;
        std::int64_t there = 0;
        left.difference = {path, read_piece(path, wanted, first, hash, there)};
        if (!left.difference.what.empty()) return left;
        if (is_joined && there < wanted) {
            left.difference.what = fmt::format("has {} records of {}", there, wanted);
            return left;
        }
        left.pieces.push_back({path, there, std::min(there, wanted)});
        total += left.pieces.back().used;
    }
    if (hash.so_far() == beginning.hash) return left;
    const std::size_t pieces = left.pieces.size();
    left.difference.what =
        pieces > 1
            ? fmt::format("or one of the {} pieces before it has changed since it was written",
                          pieces - 1)
            : "has changed since it was written";
    return left;
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

    void begin() { open_.emplace(file_, outline_, text_, hash_); }

    /// Finds what a former run left, and takes its first records.
    void resume(const FieldsBeginning& beginning, bool text_is_new) {
        text_is_new_ = text_is_new;
        LeftPieces left = find_pieces(file_, outline_, beginning, hash_);
        if (!left.difference.what.empty())
            throw InputError(fmt::format("{}: cannot be continued: it {}",
                                         left.difference.file.string(), left.difference.what));
        closed_ = std::move(left.pieces);
        total_ = beginning.records;
        std::error_code fault;
        if (!closed_.empty() && closed_.front().path == file_) {
            remove_fields_pieces(file_);
            closed_.front().path = piece_path(file_, 1);
            fs::rename(file_, closed_.front().path, fault);
            if (fault) refuse_to_write(closed_.front().path, fault.value());
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

    FieldsBeginning sync() {
        if (open_ && open_->records() > 0) {
            close_piece();
            sync_folder_of(file_);
        }
        return {total_, hash_.so_far()};
    }

    void commit() {
        if (closed_.empty()) {
            if (open_) open_->close_as(file_);
            open_.reset();
            return;
        }
        if (open_ && open_->records() > 0) close_piece();
        open_.reset();
        if (!text_is_new_ && closed_.size() == 1 &&
            closed_.front().used == closed_.front().records) {
            if (std::rename(closed_.front().path.c_str(), file_.c_str()) != 0)
                refuse_to_write(file_, errno);
            return;
        }
        Sha256Stream joined;
        FieldsPiece whole(file_, outline_, text_, joined);
        for (const ClosedPiece& piece : closed_) whole.copy(piece.path, piece.used);
        if (joined.so_far() != hash_.so_far())
            throw Error(fmt::format(
                "cannot write {}: a part of it has changed since it was written", file_.string()));
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
    Sha256Stream hash_;  ///< of the values of all records
    std::vector<ClosedPiece> closed_;
    std::optional<FieldsPiece> open_;
    std::int64_t total_ = 0;
    bool text_is_new_ = false;
};

FieldsFile::FieldsFile(const fs::path& file, const Snapshot& first, const FieldsText& text) {
    check_whole(file, first);
    parts_ = std::make_unique<Parts>(file, first, text);
    parts_->begin();
}

FieldsFile::FieldsFile(const fs::path& file, const Snapshot& first, const FieldsText& text,
                       const FieldsBeginning& previous, bool text_is_new)
    : parts_(std::make_unique<Parts>(file, first, text)) {
    parts_->resume(previous, text_is_new);
}

FieldsFile::~FieldsFile() = default;

void FieldsFile::add(const Snapshot& snapshot) {
    parts_->add(snapshot);
}

std::int64_t FieldsFile::records() const {
    return parts_->records();
}

FieldsBeginning FieldsFile::sync() {
    return parts_->sync();
}

void FieldsFile::commit() {
    parts_->commit();
}

FieldsDifference difference(const fs::path& file, const Snapshot& first,
                            const FieldsBeginning& beginning) {
    Sha256Stream hash;
    return find_pieces(resolved_link(file), first, beginning, hash).difference;
}

}  // namespace fumon
