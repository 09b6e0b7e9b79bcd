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
export function markOf(paletteIndex: number, radius: number): Path2D {
  const key = `${paletteIndex} ${radius}`
  let path = paths.get(key)
  if (!path) {
    if (paths.size > 100) paths.clear()
    const unit = new Path2D()
    drawMark(unit, paletteIndex)
    path = new Path2D()
    path.addPath(unit, new DOMMatrix([radius, 0, 0, radius, 0, 0]))
    paths.set(key, path)
  }
  return path
}

/** Draws a mark around the origin, of radius 1. */
export function drawMark(path: Path, paletteIndex: number): void {
  marks[paletteIndex % marks.length]!(path)
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
