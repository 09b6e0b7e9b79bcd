let count = 0

/** An id that no other element of the page has: several labs can stand on one page. */
export function freshId(prefix: string): string {
  return `${prefix}-${++count}`
}
