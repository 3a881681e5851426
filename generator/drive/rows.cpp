// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/drive/rows.hpp"

#include "generator/read/names.hpp"

namespace hvi::gen {

namespace {

/// Returns the head of the time and the columns of a table.
TableHead head_of(const TableWishes& wishes) {
    TableHead head{{{"t", "time", TableNumbers::doubles}}, wishes.notes};
    for_each_column(wishes.columns, [&](const std::string& name, std::size_t) {
        const auto meaning = wishes.meanings.find(without_index(name));
        head.columns.push_back(
            {name, meaning == wishes.meanings.end() ? name : meaning->second + " " + name,
             wishes.numbers});
    });
    return head;
}

std::vector<std::size_t> numbers_of(const std::vector<ColumnBox>& columns) {
    std::vector<std::size_t> numbers;
    for_each_column(columns,
                    [&](const std::string&, std::size_t number) { numbers.push_back(number); });
    return numbers;
}

}  // namespace

Rows::Rows(const TableWishes& wishes)
    : every_(wishes.every),
      has_times_(!wishes.times.empty()),
      numbers_(numbers_of(wishes.columns)),
      table_(row_file(wishes.format, wishes.file, head_of(wishes))) {}

Rows::Rows(const TableWishes& wishes, const Place& from)
    : every_(wishes.every),
      has_times_(!wishes.times.empty()),
      numbers_(numbers_of(wishes.columns)),
      table_(row_file(wishes.format, wishes.file, head_of(wishes), from.size)),
      count_(from.rows) {
    if (has_row(from.steps)) last_ = from.t;
}

void Rows::write(double time, const Value& value) {
    last_ = time;
    values_.assign(1, time);
    for (const std::size_t number : numbers_) values_.push_back(value(number));
    table_->row(values_);
    ++count_;
}

EventRows::EventRows(const EventWishes& wishes) : numbers_(numbers_of(wishes.variables)) {
    if (!wishes.has_rows()) return;
    table_.emplace(wishes.file.c_str());
    for (const char* name : {"event", "number", "t"}) table_->cell(name);
    for_each_column(wishes.variables,
                    [&](const std::string& name, std::size_t) { table_->cell(name); });
    table_->end_row();
}

EventRows::EventRows(const EventWishes& wishes, std::int64_t size)
    : numbers_(numbers_of(wishes.variables)) {
    if (wishes.has_rows()) table_.emplace(wishes.file.c_str(), size);
}

void EventRows::write(const std::string& name, std::int64_t number, double time,
                      const DrivenStepper::State& x) {
    table_->cell(name).cell(std::to_string(number)).cell(time);
    const std::size_t n = x.q.size();
    for (const std::size_t k : numbers_) table_->cell(k < n ? x.q[k] : x.p[k - n]);
    table_->end_row();
}

}  // namespace hvi::gen
