#pragma once

#include <netcdf.h>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

#include "support/command.h"

namespace fumon::test {

inline void must(int status) {
    if (status != NC_NOERR) throw std::runtime_error(nc_strerror(status));
}

/// Writes a NetCDF file as other programs do: dimensions and variables first, then values.
class NetcdfMaker {
  public:
    explicit NetcdfMaker(const std::filesystem::path& file, int format = NC_NETCDF4) {
        must(nc_create(file.c_str(), format | NC_CLOBBER, &id_));
    }
    ~NetcdfMaker() { nc_close(id_); }
    NetcdfMaker(const NetcdfMaker&) = delete;
    NetcdfMaker& operator=(const NetcdfMaker&) = delete;

    [[nodiscard]] int id() const { return id_; }
    [[nodiscard]] int dimension(const char* name, std::size_t length) const {
        int dimension = 0;
        must(nc_def_dim(id_, name, length, &dimension));
        return dimension;
    }
    [[nodiscard]] int variable(const char* name, int type, const std::vector<int>& over) const {
        int variable = 0;
        must(nc_def_var(id_, name, type, static_cast<int>(over.size()), over.data(), &variable));
        return variable;
    }
    void text(int variable, const char* name, const std::string& value) const {
        must(nc_put_att_text(id_, variable, name, value.size(), value.data()));
    }
    void number(int variable, const char* name, int type, const std::vector<double>& values) const {
        must(nc_put_att_double(id_, variable, name, type, values.size(), values.data()));
    }
    /// From the variable's beginning on.
    void values(int variable, const std::vector<std::size_t>& count,
                const std::vector<double>& values) const {
        nc_enddef(id_);
        const std::vector<std::size_t> start(count.size(), 0);
        must(nc_put_vara_double(id_, variable, start.data(), count.data(), values.data()));
    }
    /// A coordinate variable with a unit ("" for none), to be given values.
    [[nodiscard]] int axis(const char* name, int dimension, const std::string& unit,
                           int type = NC_DOUBLE) const {
        const int axis = variable(name, type, {dimension});
        if (!unit.empty()) text(axis, "units", unit);
        return axis;
    }

  private:
    int id_ = -1;
};

/// What a NetCDF file holds, as its own library tells it.
class NetcdfContent {
  public:
    explicit NetcdfContent(const std::filesystem::path& file) {
        must(nc_open(file.c_str(), NC_NOWRITE, &id_));
    }
    ~NetcdfContent() { nc_close(id_); }
    NetcdfContent(const NetcdfContent&) = delete;
    NetcdfContent& operator=(const NetcdfContent&) = delete;

    [[nodiscard]] std::size_t length(const char* dimension) const {
        int number = 0;
        std::size_t length = 0;
        must(nc_inq_dimid(id_, dimension, &number));
        must(nc_inq_dimlen(id_, number, &length));
        return length;
    }
    [[nodiscard]] std::vector<double> values(const char* name) const {
        int count = 0;
        must(nc_inq_varndims(id_, variable(name), &count));
        std::vector<int> over(static_cast<std::size_t>(count));
        must(nc_inq_vardimid(id_, variable(name), over.data()));
        std::size_t size = 1;
        for (const int dimension : over) {
            std::size_t length = 0;
            must(nc_inq_dimlen(id_, dimension, &length));
            size *= length;
        }
        std::vector<double> values(size);
        must(nc_get_var_double(id_, variable(name), values.data()));
        return values;
    }
    /// An attribute of a variable, or of the file where `name` is empty; "" where there is none.
    [[nodiscard]] std::string text(const std::string& name, const char* attribute) const {
        const int of = name.empty() ? NC_GLOBAL : variable(name.c_str());
        std::size_t length = 0;
        if (nc_inq_attlen(id_, of, attribute, &length) != NC_NOERR) return "";
        std::string text(length, '\0');
        must(nc_get_att_text(id_, of, attribute, text.data()));
        return text;
    }
    [[nodiscard]] double number(const std::string& name, const char* attribute) const {
        double value = 0.0;
        must(nc_get_att_double(id_, name.empty() ? NC_GLOBAL : variable(name.c_str()), attribute,
                               &value));
        return value;
    }

  private:
    [[nodiscard]] int variable(const char* name) const {
        int variable = 0;
        must(nc_inq_varid(id_, name, &variable));
        return variable;
    }

    int id_ = -1;
};

}  // namespace fumon::test
