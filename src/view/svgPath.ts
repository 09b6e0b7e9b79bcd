/** A path as the text that SVG knows it by: the calls of a canvas's path that shapes here are made of. */
export class SvgPath {
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
