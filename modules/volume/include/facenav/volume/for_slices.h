#pragma once
// Work on all cores, a slice of a grid at a time. The parts must not write to the same place; the result does
// not depend on how they are shared out.

#include <vtkSMPTools.h>

#include <utility>

namespace facenav::volume {

/// Calls work(k) for k = 0 .. count - 1, on all cores.
template <class Work>
void forSlices(int count, Work&& work) {
  vtkSMPTools::For(0, count, [&](vtkIdType begin, vtkIdType end) {
    for (vtkIdType k = begin; k < end; ++k) work(int(k));
  });
}

}  // namespace facenav::volume
