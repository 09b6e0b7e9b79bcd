import { applied, identity, magnification } from './matrix.ts'
import type { Matrix } from './matrix.ts'

/** One piece of a path: an SVG command with its points; an arc of a circle has its radius and flags besides. */
interface Piece {
  readonly command: 'M' | 'L' | 'A' | 'Z'
  readonly points: readonly (readonly [number, number])[]
  readonly arc?: { readonly radius: number; readonly long: boolean; readonly clockwise: boolean }
}

const turn = 2 * Math.PI

/** A canvas's path that becomes SVG: as much of Path2D as pictures use. */
export class SvgPath {
  private readonly pieces: Piece[]

  constructor(from?: SvgPath) {
    this.pieces = from ? [...from.pieces] : []
  }

  moveTo(x: number, y: number): void {
    this.pieces.push({ command: 'M', points: [[x, y]] })
  }

  /** The first line of a path goes nowhere: it begins the path. */
  lineTo(x: number, y: number): void {
    this.pieces.push({ command: this.pieces.length > 0 ? 'L' : 'M', points: [[x, y]] })
  }

  closePath(): void {
    this.pieces.push({ command: 'Z', points: [] })
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.moveTo(x, y)
    this.lineTo(x + width, y)
    this.lineTo(x + width, y + height)
    this.lineTo(x, y + height)
    this.closePath()
  }

  /** All corners with one radius. */
  roundRect(x: number, y: number, width: number, height: number, radius: number): void {
    const r = Math.min(radius, width / 2, height / 2)
    this.moveTo(x + r, y)
    this.arc(x + width - r, y + r, r, -turn / 4, 0)
    this.arc(x + width - r, y + height - r, r, 0, turn / 4)
    this.arc(x + r, y + height - r, r, turn / 4, turn / 2)
    this.arc(x + r, y + r, r, turn / 2, (3 / 4) * turn)
    this.closePath()
  }

  arc(x: number, y: number, radius: number, from: number, to: number, backwards = false): void {
    const wanted = backwards ? from - to : to - from
    // Angles beyond a whole turn are one; one that runs the other way is what it lacks to a turn.
    const whole = wanted >= turn
    const sweep = whole ? turn : ((wanted % turn) + turn) % turn
    const signed = backwards ? -sweep : sweep
    const at = (angle: number) =>
      [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const
    this.lineTo(...at(from))
    // SVG has no arc that ends where it begins.
    const parts = whole ? 2 : 1
    for (let i = 1; i <= parts; i++)
      this.pieces.push({
        command: 'A',
        points: [at(from + (signed * i) / parts)],
        arc: { radius, long: sweep / parts > turn / 2, clockwise: !backwards },
      })
  }

  addPath(path: SvgPath, matrix: Matrix = identity): void {
    this.pieces.push(...path.moved(matrix).pieces)
  }

  /** The same path, turned, moved and enlarged. */
  moved(matrix: Matrix): SvgPath {
    const result = new SvgPath()
    const scale = magnification(matrix)
    for (const { points, arc, ...piece } of this.pieces)
      result.pieces.push({
        ...piece,
        points: points.map(([x, y]) => applied(matrix, x, y)),
        ...(arc && { arc: { ...arc, radius: arc.radius * scale } }),
      })
    return result
  }

  /** For the `d` of a `<path>`: each point as its way from the one before, which takes half the letters. */
  get data(): string {
    let [x, y] = [0, 0]
    let [startX, startY] = [0, 0]
    const pieces = this.pieces.map(({ command, points, arc }) => {
      if (command === 'Z') {
        ;[x, y] = [startX, startY]
        return 'z'
      }
      const numbers = points.flatMap((point) => [tenths(point[0]) - x, tenths(point[1]) - y])
      // From the rounded place, so that what is rounded off does not add up.
      x += numbers.at(-2)!
      y += numbers.at(-1)!
      if (command === 'M') [startX, startY] = [x, y]
      if (!arc) return command.toLowerCase() + joined(numbers)
      const radius = tenths(arc.radius)
      return `a${joined([radius, radius])} 0 ${flag(arc.long)} ${flag(arc.clockwise)}${joined(numbers, ' ')}`
    })
    return pieces.join('')
  }
}

function flag(on: boolean): number {
  return on ? 1 : 0
}

/** Nobody sees more of a pixel than its tenths, and so the last bits of a sine can’t show. */
function tenths(value: number): number {
  return Math.round(value * 10) + 0
}

/** Tenths as the shortest text. A minus needs no space in front of it. */
function joined(numbers: readonly number[], before = ''): string {
  const text = numbers.map((each) => String(each / 10).replace(/^(-?)0\./, '$1.')).join(' ')
  return (before + text).replaceAll(' -', '-')
}

/** A number to a tenth of a pixel. */
export function short(value: number): string {
  return String(tenths(value) / 10)
}
