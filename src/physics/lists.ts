/** The entry of a list with that id. The id has passed `parseExperiment`, so there is one. */
export function entry<T extends { readonly id: string }>(list: readonly T[], id: string): T {
  const found = list.find((candidate) => candidate.id === id)
  if (!found)
    throw new Error(`There is no “${id}” in the list ${list.map((each) => each.id).join(', ')}.`)
  return found
}
