// SPDX-License-Identifier: BSD-3-Clause
#include "io/lines/geopackage_check.h"

#include "io/error.h"
#include "io/text/text.h"

#include <fmt/format.h>
#include <sqlite3.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

namespace ridgeline::io {
namespace {

constexpr std::uintmax_t kScannedFile_bytes = 16U << 20U;

struct DatabaseCloser {
  void operator()(sqlite3* database) const { sqlite3_close(database); }
};
struct StatementCloser {
  void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Database = std::unique_ptr<sqlite3, DatabaseCloser>;
using Statement = std::unique_ptr<sqlite3_stmt, StatementCloser>;

/// Ends a query after the steps of some seconds, because pages of a damaged file may refer to each
/// other.
void limit_steps(sqlite3* database) {
  constexpr int kSteps = 50'000'000;
  sqlite3_progress_handler(
      database, kSteps, [](void*) { return 1; }, nullptr);
}

Database open_database(const std::string& path) {
  sqlite3* raw = nullptr;
  const int error = sqlite3_open_v2(path.c_str(), &raw, SQLITE_OPEN_READONLY, nullptr);
  Database database(raw);
  if (error != SQLITE_OK) return nullptr;
  limit_steps(raw);
  return database;
}

std::string column_text(sqlite3_stmt* statement, int column) {
  const auto* const text = reinterpret_cast<const char*>(sqlite3_column_text(statement, column));
  return text == nullptr ? "" : text;
}

Statement prepare(sqlite3* database, const std::string& sql) {
  sqlite3_stmt* raw = nullptr;
  sqlite3_prepare_v2(database, sql.c_str(), -1, &raw, nullptr);
  return Statement(raw);
}

struct SchemaEntry {
  std::string name;
  bool is_view = false;
  bool is_virtual = false;
};

std::vector<SchemaEntry> schema_of(sqlite3* database) {
  const Statement statement = prepare(
      database, "SELECT name, type, sql FROM sqlite_master WHERE type IN ('table', 'view')");
  std::vector<SchemaEntry> entries;
  while (statement && sqlite3_step(statement.get()) == SQLITE_ROW) {
    const std::string sql = lower_case(column_text(statement.get(), 2));
    entries.push_back({.name = column_text(statement.get(), 0),
                       .is_view = column_text(statement.get(), 1) == "view",
                       .is_virtual = sql.starts_with("create virtual")});
  }
  return entries;
}

/// Names of the layers that the GeoPackage table `list` lists, in lower case.
std::vector<std::string> layers_of(sqlite3* database, const char* list) {
  const Statement statement =
      prepare(database, fmt::format("SELECT lower(table_name) FROM {}", list));
  std::vector<std::string> layers;
  while (statement && sqlite3_step(statement.get()) == SQLITE_ROW) {
    layers.push_back(column_text(statement.get(), 0));
  }
  return layers;
}

std::string quoted(const std::string& name) {
  std::string text = "\"";
  for (const char c : name) text += c == '"' ? "\"\"" : std::string(1, c);
  return text + "\"";
}

/// Describes what computes the rows of a layer when they are read; empty for a plain table.
std::string computed_by(sqlite3* database, const SchemaEntry& entry) {
  if (entry.is_view) return "is a view, whose query may never finish";
  if (entry.is_virtual) return "is a virtual table";
  const Statement statement =
      prepare(database, fmt::format("PRAGMA table_xinfo({})", quoted(entry.name)));
  while (statement && sqlite3_step(statement.get()) == SQLITE_ROW) {
    if (sqlite3_column_int(statement.get(), 6) != 0) {
      return "has the generated column " + column_text(statement.get(), 1);
    }
  }
  return "";
}

std::vector<std::string> columns_of_table(sqlite3* database, const std::string& table) {
  const Statement statement =
      prepare(database, fmt::format("PRAGMA table_info({})", quoted(table)));
  std::vector<std::string> columns;
  while (statement && sqlite3_step(statement.get()) == SQLITE_ROW) {
    columns.push_back(column_text(statement.get(), 1));
  }
  return columns;
}

/// Throws IoError for a binary value that is larger than the file. SQLite evaluates length() from
/// the row header, without reading the value.
void require_small_values(sqlite3* database,
                          const std::string& path,
                          const std::string& table,
                          const std::vector<std::string>& columns,
                          std::uintmax_t file_size) {
  for (const std::string& column : columns) {
    const Statement statement = prepare(
        database,
        fmt::format("SELECT 1 FROM {} WHERE typeof({}) = 'blob' AND length({}) > {} LIMIT 1",
                    quoted(table), quoted(column), quoted(column), file_size));
    const int result = statement ? sqlite3_step(statement.get()) : SQLITE_DONE;
    if (result == SQLITE_ROW) {
      throw IoError(path, fmt::format("layer {} is damaged: a value of column {} is larger than "
                                      "the file",
                                      table, column));
    }
    if (result == SQLITE_INTERRUPT) {
      throw IoError(path, fmt::format("layer {} is damaged: its rows form an endless loop", table));
    }
  }
}

std::vector<UnreadLayer> layers_without_table(sqlite3* database,
                                              const std::vector<SchemaEntry>& schema) {
  std::vector<UnreadLayer> unread;
  for (const std::string& layer : layers_of(database, "gpkg_geometry_columns")) {
    const bool has_table = std::ranges::any_of(
        schema, [&](const SchemaEntry& entry) { return lower_case(entry.name) == layer; });
    if (!has_table) unread.push_back({layer, "is listed, but has no table"});
  }
  return unread;
}

}  // namespace

std::vector<UnreadLayer> unread_layers(const std::string& path) {
  const Database database = open_database(path);
  if (!database) return {};
  const std::vector<SchemaEntry> schema = schema_of(database.get());
  for (const SchemaEntry& entry : schema) {
    // The queries below read these tables, which list the layers, so they must not be views.
    const std::string name = lower_case(entry.name);
    if (entry.is_view && (name.starts_with("gpkg_") || name.starts_with("sqlite_"))) {
      throw IoError(path, fmt::format("is not a GeoPackage: its table {} is a view", entry.name));
    }
  }
  const std::vector<std::string> layers = layers_of(database.get(), "gpkg_contents");
  const std::uintmax_t file_size = std::filesystem::file_size(path);
  std::vector<UnreadLayer> unread = layers_without_table(database.get(), schema);
  for (const SchemaEntry& entry : schema) {
    if (std::ranges::find(layers, lower_case(entry.name)) == layers.end()) continue;
    const std::string how = computed_by(database.get(), entry);
    if (!how.empty()) {
      unread.push_back({entry.name, how + "; export it as a plain table"});
    } else if (file_size <= kScannedFile_bytes) {
      require_small_values(database.get(), path, entry.name,
                           columns_of_table(database.get(), entry.name), file_size);
    }
  }
  return unread;
}

}  // namespace ridgeline::io
