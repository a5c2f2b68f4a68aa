#pragma once

#include <fmt/format.h>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "physics/scene/shape.h"

namespace carom {

// What people are told of one key of an object.
struct KeyRow {
  std::string key;
  bool required = false;
  std::string values;  // unit and range, or the words
  std::string usual;   // the default; empty: none
  std::string meaning;
};

// The visitor of fields.h that describes the keys of an object for people. Members hold their defaults. Where a
// word says which keys there are, they are listed for each word, as `word`: key.
class KeyTable : public OnlyLooks {
 public:
  template <class T>
  [[nodiscard]] static std::vector<KeyRow> of(T usual = {}) {
    return of_all([&usual](KeyTable& table) { fields(table, usual); });
  }
  // Of all that `visit` shows to a table.
  [[nodiscard]] static std::vector<KeyRow> of_all(const auto& visit) {
    KeyTable table;
    visit(table);
    return std::move(table.rows_);
  }

  void field(const Key& key, double x, const Range& range) { add(key, text_of(range), fmt::format("{}", x)); }
  void field(const Key& key, const std::optional<double>&, const Range& range) { add(key, text_of(range), ""); }
  void field(const Key& key, const Vec2& x, const Range& range) {
    add(key, "[x, y] in " + text_of(range), fmt::format("[{}, {}]", x.x(), x.y()));
  }
  void field(const Key& key, const std::string& text, const Count& length) {
    add(key, fmt::format("a text of up to {} characters", length.most), text.empty() ? "" : "`" + text + "`");
  }
  template <class Integer>
  void field(const Key& key, Integer x, const Whole& range) {
    add(key, fmt::format("a whole number from {} to {}", range.low, range.high), fmt::format("{}", x));
  }
  void field(const Key& key, bool flag) { add(key, "true or false", flag ? "true" : "false"); }
  template <class T, class Kind>
  void required(const Key& key, const T& x, const Kind& kind) {
    field(key, x, kind);
    rows_.back().required = true;
    rows_.back().usual.clear();
  }
  template <class Table, class Id>
  void choice(const Key& key, const Table& table, Id id) {
    add(key, joined(words_of(table)), "`" + words_of(table)[index_of(table, id)] + "`");
  }
  template <class T>
  void object(const Key& key, const std::optional<T>&) {
    add(key, "an object", "");
    add_all(of<T>(), std::string(key.name) + "/");
  }
  template <class T>
  void required_object(const Key& key, const T&) {
    add(key, "an object", "");
    rows_.back().required = true;
    add_all(of<T>(), std::string(key.name) + "/");
  }
  template <class T>
  void alternative(const Key& key, const T&) {
    add(key, "an object", "");
    add_all(of<T>(), std::string(key.name) + "/");
  }
  void compound(const Key& key, const Shape&, const Count&) {
    add(key, "an array of objects", "");
    add_all(of<PlacedShape>(), std::string(key.name) + "/");
  }
  void points(const Key& key, const std::vector<Vec2>&, const Count& count, const Range& range);
  void numbers(const Key& key, const std::vector<double>&, const Count& count, const Range& range);
  void ends_of_range(const Key& key, double, double, const Range& range);
  void two_names(const Key& key, const std::string&, const std::string&);
  // What no function above describes.
  void other(const Key& key, std::string values) { add(key, std::move(values), ""); }
  void required_other(const Key& key, std::string values) {
    other(key, std::move(values));
    rows_.back().required = true;
  }
  [[nodiscard]] static bool shows(bool) { return true; }
  void cases(const Key& key, const Words& words, std::size_t, const auto& each) {
    add(key, joined(words), "");
    rows_.back().required = true;
    for (std::size_t i = 0; i < words.size(); ++i) {
      KeyTable one;
      each(i, one);
      add_all(std::move(one.rows_), "`" + words[i] + "`: ");
    }
  }

 private:
  [[nodiscard]] static std::string text_of(const Range& range);
  [[nodiscard]] static std::string joined(const std::vector<std::string>& words);
  void add(const Key& key, std::string values, std::string usual) {
    rows_.push_back({key.name, false, std::move(values), std::move(usual), key.meaning});
  }
  void add_all(std::vector<KeyRow> rows, const std::string& before) {
    for (KeyRow& row : rows) {
      row.key = before + row.key;
      rows_.push_back(std::move(row));
    }
  }

  std::vector<KeyRow> rows_;
};

// As a table of a Markdown page: key (bold if required), values, default, meaning.
[[nodiscard]] std::string markdown_of(const std::vector<KeyRow>& rows);

// The keys of one type of object in a preset file.
struct KeySection {
  std::string_view title;
  std::vector<KeyRow> rows;
};
// Of an experiment as a whole, then of each type of object in it.
[[nodiscard]] std::vector<KeySection> key_sections();

}  // namespace carom
