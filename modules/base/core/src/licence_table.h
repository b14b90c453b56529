#pragma once
// The table of licences as the build wrote it: rows "name | licence | use | package | libraries | version".

namespace facenav {
inline namespace core {

const char* licenceTable();

}  // namespace core
}  // namespace facenav
