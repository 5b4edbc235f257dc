#include "files/netcdf/netcdf_piece.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

#include "files/atomic_file.h"
#include "files/disk_space.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_copy.h"
#include "files/netcdf/netcdf_form.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_values.h"
#include "files/open_files.h"

namespace fumon {

namespace {

constexpr int closed = -1;

}  // namespace

class FieldsPiece::Parts {
  public:
    Parts(const std::filesystem::path& file, const Snapshot& first, const FieldsText& text,
          Sha256Stream& hash)
        : file_(resolved_link(file)),
          part_(std::filesystem::absolute(file_)),  // which is never taken for a network address
          form_(record_form(first)) {
        part_ = temporary_name(part_);
        if (!takes_a_rename(file_))
            throw Error(fmt::format(
                "cannot write {}: it is a pipe or a device; NetCDF needs a file on disk",
                file_.string()));
        record_room_ = record_room(first);
        try {
            make(first, text, hash);
        } catch (...) {
            discard();
            throw;
        }
    }

    ~Parts() { discard(); }
    Parts(const Parts&) = delete;

    void copy(const std::filesystem::path& from, std::int64_t count) {
        const NetcdfLock lock;
        try {
            const NetcdfInput input(from);
            const SourceVariables source = source_variables(input, form_.fields, form_.numbers);
            for (std::int64_t record = 0; record < count; ++record, ++records_) {
                reserve(record_room_);
                copy_record(input, source, static_cast<std::size_t>(record), *values_, layout_,
                            form_.nx, form_.ny, static_cast<std::size_t>(records_));
                check_netcdf(nc_sync(netcdf_.id()));
            }
        } catch (const NetcdfFault& fault) {
            broken_ = true;
            throw Error(fmt::format("cannot copy {} into {}: {}; is its disk full or broken?",
                                    from.string(), file_.string(), fault.what()));
        }
    }

    Parts& operator=(const Parts&) = delete;

    void add(const Snapshot& snapshot) {
        check_form(file_, form_, snapshot);
        refuse_if_lost(broken_);
        reserve(record_room(snapshot));
        const NetcdfLock lock;
        try {
            write(snapshot);
        } catch (const NetcdfFault& fault) {
            broken_ = true;
            fail(fault);
        }
        ++records_;
    }

    void close_as(const std::filesystem::path& name) {
        refuse_if_lost(false);
        {
            const NetcdfLock lock;
            const bool whole = netcdf_.close();
            release_space(descriptor_);
            if (!whole) fail(NetcdfFault("closing it failed"));
            if (broken_) check_opens();
        }
        if (::fsync(descriptor_) != 0 && errno != EINVAL) refuse_to_write(file_, errno);
        if (::close(std::exchange(descriptor_, closed)) != 0 && errno != EINTR)
            refuse_to_write(file_, errno);
        if (::rename(part_.c_str(), name.c_str()) != 0) refuse_to_write(file_, errno);
        part_.clear();
    }

    [[nodiscard]] std::int64_t records() const { return records_; }

  private:
    void make(const Snapshot& first, const FieldsText& text, Sha256Stream& hash) {
        ::unlink(part_.c_str());                    // what a killed run may have left
        constexpr mode_t default_file_mode = 0666;  // less the umask
        descriptor_ =
            ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, default_file_mode);
        if (descriptor_ < 0) refuse_to_write(file_, errno);
        reserve(header_room(first, text) + record_room(first));
        const NetcdfLock lock;
        try {
            netcdf_ = NetcdfHandle::create(part_);
            reserve(header_room(first, text) + record_room(first));  // making it gave that back
            layout_ = define_fields(netcdf_.id(), first, text);
            values_.emplace(netcdf_.id(), hash);
            check_netcdf(nc_sync(netcdf_.id()));
        } catch (const NetcdfFault& fault) {
            fail(fault);
        }
    }

    void refuse_if_lost(bool broken) const {
        if (broken || !netcdf_.is_open())
            throw Error(fmt::format("cannot write {}: an earlier record failed", file_.string()));
    }

    /// After a fault of the device the records before it are mostly there; only a file that opens
    /// gets its name.
    void check_opens() const {
        try {
            const auto opened = NetcdfHandle::open_to_read(part_);
        } catch (const NetcdfFault& fault) {
            fail(fault);
        }
    }

    void discard() {
        const NetcdfLock lock;
        (void)netcdf_.close();
        if (descriptor_ >= 0) ::close(std::exchange(descriptor_, closed));
        if (!part_.empty()) ::unlink(part_.c_str());
    }

    [[noreturn]] void fail(const NetcdfFault& fault) const {
        if (const int shortage = shortage_of_open_files()) refuse_to_write(file_, shortage);
        throw Error(fmt::format("cannot write {}: {}; is its disk full or broken?", file_.string(),
                                fault.what()));
    }

    void reserve(std::int64_t bytes) const {
        const int reason = reserve_space(descriptor_, bytes);
        if (reason == 0) return;
        throw Error(fmt::format(
            "cannot write {}: {}; its next record needs up to {} KiB: free some space, or write "
            "fields less often",
            file_.string(), std::generic_category().message(reason), (bytes + 1023) / 1024));
    }

    /// The time comes last: a record whose time is not the _FillValue is complete.
    void write(const Snapshot& snapshot) {
        const auto record = static_cast<std::size_t>(records_);
        write_field(layout_.bed, snapshot.bed, snapshot.nodata, layout_.bed_factor);
        for (std::size_t i = 0; i < layout_.fields.size(); ++i)
            write_field(layout_.fields[i], snapshot.fields[i].values, snapshot.nodata, 1.0);
        for (std::size_t i = 0; i < layout_.numbers.size(); ++i)
            values_->put(layout_.numbers[i], record, snapshot.numbers[i].value);
        if (layout_.section) write_section(*values_, *layout_.section, record, *snapshot.section);
        values_->put(layout_.step, record, static_cast<long long>(snapshot.step));
        values_->put_derived(layout_.date, record, snapshot.time * layout_.date_factor);
        values_->put(layout_.time, record, snapshot.time);
        check_netcdf(nc_sync(netcdf_.id()));
    }

    /// In blocks of the chunks' rows, so that a block and no field is copied.
    void write_field(int variable, const Grid& values, const Mask& nodata, double factor) {
        const auto nx = static_cast<std::size_t>(values.nx());
        for (int y = 0; y < values.ny(); y += layout_.rows) {
            const auto rows = static_cast<std::size_t>(std::min(layout_.rows, values.ny() - y));
            const std::size_t begin = static_cast<std::size_t>(y) * nx;
            const auto cells = values.values().subspan(begin, rows * nx);
            block_.resize(cells.size());
            for (std::size_t i = 0; i < cells.size(); ++i) block_[i] = cells[i] * factor;
            if (!nodata.empty()) {
                const auto mask = nodata.values().subspan(begin, rows * nx);
                for (std::size_t i = 0; i < mask.size(); ++i) {
                    if (mask[i] != 0) block_[i] = std::numeric_limits<double>::quiet_NaN();
                }
            }
            const std::array<std::size_t, 3> start{static_cast<std::size_t>(records_),
                                                   static_cast<std::size_t>(y), 0};
            const std::array<std::size_t, 3> count{1, rows, nx};
            values_->put(variable, start, count, block_.data());
        }
    }

    std::filesystem::path file_;
    std::filesystem::path part_;
    RecordForm form_;
    std::int64_t record_room_ = 0;  ///< of a record like the first, bytes
    int descriptor_ = closed;       ///< of the .part, for setting space aside
    NetcdfHandle netcdf_;
    FieldsLayout layout_;
    std::optional<RecordValues> values_;
    std::vector<double> block_;
    std::int64_t records_ = 0;
    bool broken_ = false;
};

FieldsPiece::FieldsPiece(const std::filesystem::path& file, const Snapshot& first,
                         const FieldsText& text, Sha256Stream& hash)
    : parts_(std::make_unique<Parts>(file, first, text, hash)) {}

FieldsPiece::~FieldsPiece() = default;

void FieldsPiece::add(const Snapshot& snapshot) {
    parts_->add(snapshot);
}

void FieldsPiece::copy(const std::filesystem::path& from, std::int64_t count) {
    parts_->copy(from, count);
}

std::int64_t FieldsPiece::records() const {
    return parts_->records();
}

void FieldsPiece::close_as(const std::filesystem::path& name) {
    parts_->close_as(name);
}

}  // namespace fumon
