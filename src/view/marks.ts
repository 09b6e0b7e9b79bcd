/** What a mark is drawn on: a canvas's path, or one for SVG. */
type Path = Pick<Path2D, 'arc' | 'closePath' | 'lineTo' | 'rect'>

/**
 * The eight marks that tell runners apart without colour, each drawn into a circle around the origin of radius 1 and
 * of about the same weight.
 */
const marks: readonly ((path: Path) => void)[] = [
  (path) => polygon(path, 3, 1, -Math.PI / 2),
  (path) => path.arc(0, 0, 0.78, 0, 2 * Math.PI),
  (path) => path.rect(-0.7, -0.7, 1.4, 1.4),
  (path) => polygon(path, 4, 1, -Math.PI / 2),
  (path) => {
    path.rect(-0.95, -0.28, 1.9, 0.56)
    path.rect(-0.28, -0.95, 0.56, 1.9)
  },
  (path) => star(path),
  (path) => path.rect(-0.95, -0.36, 1.9, 0.72),
  (path) => {
    path.arc(0, 0, 0.9, 0, 2 * Math.PI)
    path.arc(0, 0, 0.48, 0, 2 * Math.PI, true)
  },
]

const paths = new Map<string, Path2D>()

/** A mark of a radius around the origin. */
export function markOf(look: number, radius: number): Path2D {
  const key = `${look} ${radius}`
  let path = paths.get(key)
  if (!path) {
    if (paths.size > 100) paths.clear()
    const unit = new Path2D()
    marks[look % marks.length]!(unit)
    path = new Path2D()
    path.addPath(unit, new DOMMatrix([radius, 0, 0, radius, 0, 0]))
    paths.set(key, path)
  }
  return path
}

/** The same around a point. */
export function markPath(look: number, x: number, y: number, radius: number): Path2D {
  const path = new Path2D()
  path.addPath(markOf(look, radius), new DOMMatrix().translate(x, y))
  return path
}

/** A mark around the origin, of radius 1, for SVG. */
export function markText(look: number): string {
  const path = new SvgPath()
  marks[look % marks.length]!(path)
  return path.text
}

function polygon(path: Path, corners: number, radius: number, start: number): void {
  for (let i = 0; i < corners; i++) {
    const angle = start + (2 * Math.PI * i) / corners
    path.lineTo(radius * Math.cos(angle), radius * Math.sin(angle))
  }
  path.closePath()
}

function star(path: Path): void {
  for (let i = 0; i < 10; i++) {
    const radius = i % 2 === 0 ? 1.05 : 0.45
    const angle = -Math.PI / 2 + (Math.PI * i) / 5
    path.lineTo(radius * Math.cos(angle), radius * Math.sin(angle))
  }
  path.closePath()
}

/** A path as the text that SVG knows it by: the calls of a canvas's path that shapes here are made of. */
class SvgPath {
  private readonly parts: string[] = []

  /** The value of a path element's `d`. */
  get text(): string {
    return this.parts.join('')
  }

  lineTo(x: number, y: number): void {
    this.parts.push(`${this.parts.length > 0 ? 'L' : 'M'}${short(x)} ${short(y)}`)
  }

  closePath(): void {
    this.parts.push('Z')
  }

  rect(x: number, y: number, width: number, height: number): void {
    this.parts.push(`M${short(x)} ${short(y)}h${short(width)}v${short(height)}h${short(-width)}Z`)
  }

  /** Only whole circles. */
  arc(x: number, y: number, radius: number, _: number, __: number, against = false): void {
    const half = `a${short(radius)} ${short(radius)} 0 0 ${against ? 0 : 1} `
    const across = short(2 * radius)
    this.parts.push(`M${short(x - radius)} ${short(y)}${half}${across} 0${half}-${across} 0Z`)
  }
}

function short(x: number): string {
  return String(Number(x.toFixed(3)))
}
