// SPDX-FileCopyrightText: 2026 The Voussoir authors
// SPDX-License-Identifier: Apache-2.0
#include "solver/team/place.h"

#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <memory>
#include <vector>

namespace voussoir::solver {

void place_thread(int thread) {
  const int places = omp_get_num_places();
  if (places < 1 || omp_get_proc_bind() == omp_proc_bind_false) return;
  const int place = thread % places;
  std::vector<int> processors(static_cast<std::size_t>(omp_get_place_num_procs(place)));
  omp_get_place_proc_ids(place, processors.data());
  if (processors.empty()) return;
  const std::size_t count = static_cast<std::size_t>(*std::ranges::max_element(processors)) + 1, size = CPU_ALLOC_SIZE(count);
  const std::unique_ptr<cpu_set_t, void (*)(cpu_set_t*)> set(CPU_ALLOC(count), [](cpu_set_t* s) { CPU_FREE(s); });
  CPU_ZERO_S(size, set.get());
  for (const int id : processors) CPU_SET_S(static_cast<std::size_t>(id), size, set.get());
  sched_setaffinity(0, size, set.get());
}

}  // namespace voussoir::solver
