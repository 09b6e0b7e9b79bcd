/**
 * The entry of a list with an id; `Named` is its type where the id determines it.
 *
 * @throws Error if there is none, which cannot happen to an id that has passed `parseExperiment`
 */
export function entry<T extends { readonly id: string }, Named extends T = T>(
  list: readonly T[],
  id: string,
): Named {
  const found = list.find((candidate): candidate is Named => candidate.id === id)
  if (!found)
    throw new Error(`There is no “${id}” in the list ${list.map((each) => each.id).join(', ')}.`)
  return found
}
