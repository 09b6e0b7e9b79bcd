const decimal = /^[+-]?(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?$/i

/** The number in a cell, with a decimal point or a decimal comma; NaN where it is none. */
export function readCell(text: string): number {
  const point = text.includes(',') ? pointed(text) : text
  return decimal.test(point) ? Number(point) : NaN
}

/** With a point where the decimal comma was, and without the signs that separate thousands: “1.234,5” is 1234.5. */
function pointed(text: string): string {
  const last = Math.max(text.lastIndexOf(','), text.lastIndexOf('.'))
  return `${text.slice(0, last).replace(/[.,]/g, '')}.${text.slice(last + 1)}`
}
