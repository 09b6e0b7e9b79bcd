/** These stay as they are: runs can be repeated and positions compared from them. */
const exact = new Set(['position', 'truth', 'parameters', 'duration', 'setting'])

/** Rounds values to five digits, more than their accuracy. */
export function rounded<T>(value: T): T {
  return tidy(value) as T
}

function tidy(value: unknown): unknown {
  if (typeof value === 'number') return Number(value.toPrecision(5))
  if (Array.isArray(value)) return value.map(tidy)
  if (typeof value !== 'object' || value === null) return value
  return Object.fromEntries(
    Object.entries(value).map(([key, each]) => [key, exact.has(key) ? each : tidy(each)]),
  )
}
