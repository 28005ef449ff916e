#include <algorithm>
#include <tuple>
#include <utility>

#include "measure/formats/file_bytes.hpp"
#include "measure/formats/hdf5_heap.hpp"
#include "measure/formats/hdf5_object.hpp"

namespace secular {
namespace {

class SymbolTable {
 public:
  SymbolTable(const Hdf5Bytes& file, const Hdf5SymbolTable& table) : file_(file), nodes_left_(file.size() / 24) {
    Hdf5Cursor heap(file.at(table.heap, 32), table.heap);
    if (heap.take(4) != "HEAP") heap.fail("the names of a group are missing");
    heap.skip(4);
    const std::uint64_t size = heap.number(8);
    heap.skip(8);
    names_ = file.at(heap.number(8), size);
    read_node(table.tree, hdf5_deepest_tree);
  }

  std::vector<Hdf5Link> links;

 private:
  void read_node(std::uint64_t address, int levels) {
    Hdf5Cursor node(file_.at(address, 24), address);
    if (nodes_left_-- == 0 || levels == 0) node.fail("the list of a group goes round in circles");
    const std::string_view signature = node.take(4);
    if (signature == "SNOD") return read_symbols(address);
    if (signature != "TREE" || node.number(1) != 0) node.fail("the list of a group is damaged");
    node.skip(1);
    const std::uint64_t children = node.number(2);
    Hdf5Cursor entries(file_.at(address + 24, 16 * children), address + 24);
    for (std::uint64_t i = 0; i < children; ++i) {
      entries.skip(8);
      read_node(entries.number(8), levels - 1);
    }
  }

  void read_symbols(std::uint64_t address) {
    constexpr std::uint64_t symbol_size = 40;
    Hdf5Cursor head(file_.at(address, 8), address);
    head.skip(6);
    const std::uint64_t count = head.number(2);
    Hdf5Cursor symbols(file_.at(address + 8, symbol_size * count), address + 8);
    for (std::uint64_t i = 0; i < count; ++i) {
      const std::uint64_t name = symbols.number(8), object = symbols.number(8), kind = symbols.number(4);
      symbols.skip(4);
      const std::uint64_t target = symbols.number(4);
      symbols.skip(12);
      constexpr std::uint64_t symbolic = 2;
      Hdf5Link link{text_at(name, symbols), object};
      if (kind == symbolic) link.target = text_at(target, symbols);
      links.push_back(std::move(link));
    }
  }

  std::string text_at(std::uint64_t place, const Hdf5Cursor& symbols) const {
    if (place >= names_.size()) symbols.fail("a name stands outside of the names of its group");
    const std::string_view rest = names_.substr(place);
    const std::size_t end = rest.find('\0');
    if (end == std::string_view::npos) symbols.fail("a name has no end");
    return as_utf8(rest.substr(0, end));
  }

  const Hdf5Bytes& file_;
  std::uint64_t nodes_left_;
  std::string_view names_;
};

// Every link is in the index by name; the order of that index (hashes) says nothing to anyone.
std::vector<Hdf5Link> dense_links(const Hdf5Bytes& file, const Hdf5DenseLinks& dense, std::string& fault) {
  Hdf5Heap heap(file, dense.heap);
  if (heap.filtered()) {
    fault = "is a group whose list of members is compressed, which is not read: h5repack --low=0 --high=0 helps";
    return {};
  }
  std::vector<Hdf5Link> links;
  for (const Hdf5Record& record : hdf5_tree_records(file, dense.index, Hdf5TreeKind::links_by_name)) {
    Hdf5Cursor cursor(record.bytes, record.address);
    cursor.skip(4);  // hash
    const std::uint64_t at = cursor.address();
    const Hdf5Record object = heap.object({cursor.take(cursor.left()), at});
    if (std::optional<Hdf5Link> link = read_hdf5_link({object.bytes, object.address}))
      links.push_back(std::move(*link));
  }
  return links;
}

}  // namespace

std::vector<Hdf5Link> hdf5_members(const Hdf5Bytes& file, const Hdf5Object& group, std::string& fault) {
  if (group.symbol_table) return SymbolTable(file, *group.symbol_table).links;
  if (!group.dense_links) return group.links;
  std::vector<Hdf5Link> links = dense_links(file, *group.dense_links, fault);
  std::sort(links.begin(), links.end(), [](const Hdf5Link& a, const Hdf5Link& b) {
    return std::tie(a.created, a.name, a.address) < std::tie(b.created, b.name, b.address);
  });
  return links;
}

}  // namespace secular
