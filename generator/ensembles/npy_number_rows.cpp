// Rows of an NPY file: a structured array.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cstddef>
#include <utility>
#include <variant>

#include "generator/ensembles/number_formats.hpp"
#include "generator/read/npy_head.hpp"

namespace hvi::gen {

namespace {

double number_at(NpyType type, const char* bytes) {
    return std::visit([](auto value) { return static_cast<double>(value); },
                      npy_value(type, bytes));
}

std::vector<std::string> names_of(const NpyHead& head) {
    std::vector<std::string> names;
    for (const NpyField& field : head.fields) names.push_back(field.name);
    return names;
}

class NpyNumberRows : public NumberRows {
public:
    NpyNumberRows(NumberFile file, NpyHead head, std::ifstream stream)
        : NumberRows(file, names_of(head), static_cast<std::int64_t>(head.count)),
          file_(std::move(file)),
          head_(std::move(head)),
          stream_(std::move(stream)) {}

    std::vector<double> rows(std::int64_t first, std::int64_t count) override {
        HVI_CHECK(0 <= first && 0 <= count && first + count <= this->count());
        std::string bytes(static_cast<std::size_t>(count) * head_.size, '\0');
        stream_.clear();
        stream_.seekg(static_cast<std::streamoff>(head_.begin +
                                                  static_cast<std::size_t>(first) * head_.size));
        stream_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
        if (static_cast<std::size_t>(stream_.gcount()) != bytes.size()) refuse_changed(file_);
        std::vector<double> numbers;
        numbers.reserve(static_cast<std::size_t>(count) * head_.fields.size());
        for (std::size_t at = 0; at < bytes.size(); at += head_.size)
            for (const NpyField& field : head_.fields)
                numbers.push_back(number_at(field.type, bytes.data() + at + field.offset));
        return numbers;
    }

private:
    NumberFile file_;
    NpyHead head_;
    std::ifstream stream_;
};

}  // namespace

std::unique_ptr<NumberRows> npy_number_rows(const NumberFile& file, std::ifstream stream) {
    NpyHead head = npy_head(file, stream);
    if (!head.has_names)
        refuse(file, "the columns of this array have no names",
               "numpy.save(file, numpy.rec.fromarrays(x.T, names='x, px')) gives them");
    if (head.extents.size() != 1)
        refuse(file, "this array has more dimensions than one", "save x.ravel()");
    check_names(file, names_of(head));
    return std::make_unique<NpyNumberRows>(file, std::move(head), std::move(stream));
}

}  // namespace hvi::gen
