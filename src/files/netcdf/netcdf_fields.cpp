#include "files/netcdf/netcdf_fields.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <netcdf.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <limits>
#include <optional>
#include <span>
#include <system_error>
#include <utility>
#include <vector>

#include "files/appended_file.h"
#include "files/disk_space.h"
#include "files/netcdf/netcdf_calls.h"
#include "files/netcdf/netcdf_copy.h"
#include "files/netcdf/netcdf_input.h"
#include "files/netcdf/netcdf_layout.h"
#include "files/netcdf/netcdf_values.h"
#include "files/open_files.h"

namespace fumon {

namespace {

constexpr int closed = -1;

/// What the sections of every record have in common.
struct SectionForm {
    double dx = 0.0;
    double dz = 0.0;
    int nz = 0;
    std::vector<std::string> fields;
    std::vector<std::string> curves;
    std::size_t paths = 0;

    bool operator==(const SectionForm&) const = default;
};

/// What every record of a file has in common.
struct RecordForm {
    int nx = 0;
    int ny = 0;
    WorldScale scale;
    std::vector<std::string> fields;
    std::vector<std::string> numbers;
    std::optional<SectionForm> section;
};

template <class Named>
std::vector<std::string> names_of(const std::vector<Named>& list) {
    std::vector<std::string> names;
    names.reserve(list.size());
    for (const Named& entry : list) names.push_back(entry.name);
    return names;
}

std::optional<SectionForm> form_of(const SnapshotSection* section) {
    if (section == nullptr) return std::nullopt;
    return SectionForm{section->dx,
                       section->dz,
                       section->fields.empty() ? 0 : section->fields.front().values.ny(),
                       names_of(section->fields),
                       names_of(section->curves),
                       section->paths.size()};
}

RecordForm form_of(const Snapshot& snapshot) {
    return {snapshot.bed.nx(),         snapshot.bed.ny(),          snapshot.scale,
            names_of(snapshot.fields), names_of(snapshot.numbers), form_of(snapshot.section.get())};
}

std::filesystem::path former_name(const std::filesystem::path& file) {
    std::filesystem::path former = resolved_link(file);
    former += ".former";
    return former;
}

/// The variables of a file as it would be made, held in memory alone.
FieldsLayout layout_of(const Snapshot& first) {
    int scratch = closed;
    check_netcdf(nc_create("fields", NC_NETCDF4 | NC_DISKLESS, &scratch));
    const struct Closed {
        int file;
        ~Closed() { nc_abort(file); }
    } at_end{scratch};
    return define_fields(scratch, first, {});
}

bool has_size(const Grid& grid, const RecordForm& form) {
    return grid.nx() == form.nx && grid.ny() == form.ny;
}

}  // namespace

class FieldsFile::Parts {
  public:
    Parts(const std::filesystem::path& file, const Snapshot& first, const FieldsText& text)
        : file_(resolved_link(file)),
          part_(std::filesystem::absolute(file_)),  // which is never taken for a network address
          form_(form_of(first)) {
        part_ = temporary_name(part_);
        if (!takes_a_rename(file_))
            throw Error(fmt::format(
                "cannot write {}: it is a pipe or a device; NetCDF needs a file on disk",
                file_.string()));
        check_whole(first);
        record_room_ = record_room(first);
        try {
            make(first, text);
        } catch (...) {
            discard();
            throw;
        }
    }

    ~Parts() { discard(); }
    Parts(const Parts&) = delete;

    /// Where the records of a former run lie from now on.
    static std::filesystem::path set_aside(const std::filesystem::path& file) {
        std::filesystem::path former = former_name(file);
        const std::filesystem::path left = left_fields(file);
        std::error_code fault;
        if (!std::filesystem::exists(left, fault))
            throw InputError(
                fmt::format("{}: cannot go on with it: it is not there", left.string()));
        if (left != former) std::filesystem::rename(left, former, fault);
        if (fault) refuse_to_write(former, fault.value());
        return former;
    }

    void copy(const std::filesystem::path& former, const FieldsBeginning& beginning) {
        const NetcdfLock lock;
        const std::string differs =
            copy_records(former, beginning, *values_, layout_, form_.nx, form_.ny, [&] {
                flush();
                reserve(record_room_);
                ++records_;
            });
        if (!differs.empty()) {
            throw InputError(
                fmt::format("{}: cannot go on with it: it {}", former.string(), differs));
        }
        flush();
        std::error_code fault;
        sync();
        std::filesystem::remove(former, fault);
        keep_ = true;
    }

    FieldsBeginning sync() const {
        if (::fsync(descriptor_) != 0) refuse_to_write(file_, errno);
        return {records_, values_->hash()};
    }

    Parts& operator=(const Parts&) = delete;

    void add(const Snapshot& snapshot) {
        check_form(snapshot);
        if (broken_)
            throw Error(fmt::format("cannot write {}: an earlier record failed", file_.string()));
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

    void commit() {
        const NetcdfLock lock;
        const int status = nc_close(std::exchange(netcdf_, closed));
        release_space(descriptor_);
        if (broken_ || status != NC_NOERR) check_opens();
        if (::rename(part_.c_str(), file_.c_str()) != 0) refuse_to_write(file_, errno);
        part_.clear();
    }

    [[nodiscard]] std::int64_t records() const { return records_; }

  private:
    void make(const Snapshot& first, const FieldsText& text) {
        ::unlink(part_.c_str());                              // what a killed run may have left
        constexpr mode_t everyone_may_read_and_write = 0666;  // less the umask
        descriptor_ = ::open(part_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC,
                             everyone_may_read_and_write);
        if (descriptor_ < 0) refuse_to_write(file_, errno);
        reserve(header_room(first, text) + record_room(first));
        const NetcdfLock lock;
        try {
            check_netcdf(nc_create(part_.c_str(), NC_NETCDF4 | NC_CLOBBER, &netcdf_));
            reserve(header_room(first, text) + record_room(first));  // making it gave that back
            layout_ = define_fields(netcdf_, first, text);
            values_.emplace(netcdf_);
            check_netcdf(nc_sync(netcdf_));
        } catch (const NetcdfFault& fault) {
            fail(fault);
        }
    }

    /// After a fault of the device the records before it are mostly there; only a file that opens
    /// gets its name.
    void check_opens() const {
        int opened = closed;
        const int status = nc_open(part_.c_str(), NC_NOWRITE, &opened);
        if (status != NC_NOERR) fail(NetcdfFault(nc_strerror(status)));
        nc_close(opened);
    }

    void discard() {
        const NetcdfLock lock;
        if (netcdf_ != closed) nc_close(std::exchange(netcdf_, closed));
        if (descriptor_ >= 0) ::close(std::exchange(descriptor_, closed));
        if (!part_.empty() && !keep_) ::unlink(part_.c_str());
    }

    void flush() const {
        const int status = nc_sync(netcdf_);
        if (status != NC_NOERR) fail(NetcdfFault(nc_strerror(status)));
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

    [[noreturn]] void refuse_form(std::string_view what) const {
        throw Error(fmt::format("cannot write {}: {}; all records of a file are alike",
                                file_.string(), what));
    }

    void check_whole(const Snapshot& snapshot) const {
        if (snapshot.bed.empty()) refuse_form("the bed has no cells");
        for (const SnapshotField& field : snapshot.fields) {
            if (!has_size(field.values, form_))
                refuse_form(fmt::format("{} has {} x {} cells, the bed {} x {}", field.name,
                                        field.values.nx(), field.values.ny(), form_.nx, form_.ny));
        }
        if (!snapshot.nodata.empty() &&
            (snapshot.nodata.nx() != form_.nx || snapshot.nodata.ny() != form_.ny))
            refuse_form("the mask's size is not the bed's");
        if (snapshot.section) check_whole(*snapshot.section);
    }

    void check_whole(const SnapshotSection& section) const {
        constexpr int fewest = 2;  // nodes from which a spacing can be told
        const int nz = form_.section->nz;
        if (form_.ny != 1 || form_.nx < fewest || nz < fewest)
            refuse_form(fmt::format(
                "a section of {} x {} nodes stands on a bed of {} x {} cells; it has 2 x 2 nodes "
                "or more, and its bed one row",
                form_.nx, nz, form_.nx, form_.ny));
        for (const SnapshotField& field : section.fields) {
            if (field.values.nx() != form_.nx || field.values.ny() != nz)
                refuse_form(fmt::format("{} has {} x {} nodes, the section {} x {}", field.name,
                                        field.values.nx(), field.values.ny(), form_.nx, nz));
        }
        for (const SectionCurve& curve : section.curves) {
            if (curve.values.size() != static_cast<std::size_t>(form_.nx))
                refuse_form(fmt::format("{} has {} values, the section {} columns", curve.name,
                                        curve.values.size(), form_.nx));
        }
        for (const GrainPath& path : section.paths) {
            if (path.x.size() != path.z.size())
                refuse_form(fmt::format("a path has {} x and {} z", path.x.size(), path.z.size()));
        }
    }

    void check_form(const Snapshot& snapshot) const {
        const RecordForm form = form_of(snapshot);
        if (!has_size(snapshot.bed, form_))
            refuse_form(fmt::format("step {} has {} x {} cells, the file {} x {}", snapshot.step,
                                    form.nx, form.ny, form_.nx, form_.ny));
        if (form.scale != form_.scale)
            refuse_form(fmt::format("step {} has another scale", snapshot.step));
        if (form.fields != form_.fields || form.numbers != form_.numbers)
            refuse_form(fmt::format("step {} has other fields or numbers", snapshot.step));
        if (form.section != form_.section)
            refuse_form(fmt::format(
                "step {} has another section, in its spacing, fields, curves or number of paths",
                snapshot.step));
        check_whole(snapshot);
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
        values_->put(layout_.time, record, snapshot.time);
        check_netcdf(nc_sync(netcdf_));
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
    bool keep_ = false;             ///< even if it is not committed
    int descriptor_ = closed;       ///< of the .part, for setting space aside
    int netcdf_ = closed;
    FieldsLayout layout_;
    std::optional<RecordValues> values_;
    std::vector<double> block_;
    std::int64_t records_ = 0;
    bool broken_ = false;
};

FieldsFile::FieldsFile(const std::filesystem::path& file, const Snapshot& first,
                       const FieldsText& text)
    : parts_(std::make_unique<Parts>(file, first, text)) {}

FieldsFile::FieldsFile(const std::filesystem::path& file, const Snapshot& first,
                       const FieldsText& text, const FieldsBeginning& former) {
    const std::filesystem::path set_aside = Parts::set_aside(file);
    parts_ = std::make_unique<Parts>(file, first, text);
    parts_->copy(set_aside, former);
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

std::filesystem::path left_fields(const std::filesystem::path& file) {
    std::error_code fault;
    const std::filesystem::path former = former_name(file);  // a copy of it was broken off
    return std::filesystem::exists(former, fault) ? former : left_name(file);
}

std::string difference(const std::filesystem::path& file, const Snapshot& first,
                       const FieldsBeginning& beginning) {
    const std::filesystem::path left = left_fields(file);
    std::error_code fault;
    if (!std::filesystem::exists(left, fault)) return "is not there";
    if (!std::filesystem::is_regular_file(left, fault)) return "is no file";
    const NetcdfLock lock;
    RecordValues hashed(std::nullopt);
    return copy_records(left, beginning, hashed, layout_of(first), first.bed.nx(), first.bed.ny(),
                        [] {});
}

}  // namespace fumon
