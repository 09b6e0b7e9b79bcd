import type { ExactMotion, State } from '../state.ts'
import { cardinal } from '../trigonometry.ts'

// From here on cosh x and sinh x are eˣ/2 to the last bit.
const STEADY = 20

/**
 * A fall with drag c v|v|: dv/dt = g − k v|v|, k = c/m. With w = √(gk), which is g over the terminal speed:
 *
 *     falling:  v = (v₀ + g T)/(1 + k v₀ T),  T = tanh(wt)/w   (below, at and above the terminal speed)
 *               s = s₀ + ln(cosh wt + (k v₀/w) sinh wt)/k
 *     rising:   the same for −v with −g: tan, cos and sin in place of tanh, cosh and sinh
 *
 * (Lamb, Dynamics, 1914, on resisted motion.) The logarithm is written ln(1 + kA)/k, with A the distance that w and t
 * alone determine. Without drag, A is the parabola, so that little drag and short times lose no digits.
 */
export function exactFall(parameters: {
  gravity: number
  mass: number
  drag: number
  position: number
  speed: number
}): ExactMotion {
  const { gravity, mass, drag, position, speed } = parameters
  const k = drag / mass
  // Roots of the factors, since the product of two small ones may underflow.
  const w = Math.sqrt(gravity) * Math.sqrt(k)
  const topTime = speed < 0 ? climbTime(gravity, k, w, -speed) : 0
  const top = { s: position, v: speed }
  if (topTime > 0 && topTime < Infinity) rise(topTime, top)
  const fallSpeed = Math.max(0, speed)

  return (t, into) => (t < topTime ? rise(t, into) : fall(t - topTime, into))

  function rise(t: number, into: State): State {
    const x = w * t
    const T = t * cardinal(Math.tan(x), x)
    const half = t * cardinal(Math.sin(x / 2), x / 2)
    const A = -speed * t * cardinal(Math.sin(x), x) - 0.5 * gravity * half * half
    into.s = position - A * cardinal(Math.log1p(k * A), k * A)
    into.v = (speed + gravity * T) / (1 - k * speed * T)
    return into
  }

  function fall(t: number, into: State): State {
    const x = w * t
    const T = t * cardinal(Math.tanh(x), x)
    into.v = (fallSpeed + gravity * T) / (1 + k * fallSpeed * T)
    if (x > STEADY) {
      into.s = top.s + (gravity / w) * t + Math.log(0.5 + (0.5 * fallSpeed * k) / w) / k
      return into
    }
    const half = t * cardinal(Math.sinh(x / 2), x / 2)
    const A = fallSpeed * t * cardinal(Math.sinh(x), x) + 0.5 * gravity * half * half
    into.s = top.s + A * cardinal(Math.log1p(k * A), k * A)
    return into
  }
}

/** How long a ball that starts upwards with `speed` rises: atan(speed k/w)/w [s]. */
function climbTime(gravity: number, k: number, w: number, speed: number): number {
  if (gravity === 0) return Infinity
  const y = speed * (Math.sqrt(k) / Math.sqrt(gravity))
  return y < 1 ? (speed / gravity) * cardinal(Math.atan(y), y) : Math.atan(y) / w
}
