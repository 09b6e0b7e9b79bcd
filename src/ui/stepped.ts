import type { NumberControl } from '../figures/shared/control.ts'

const moves: Readonly<Record<string, number>> = {
  ArrowRight: 1,
  ArrowUp: 1,
  ArrowLeft: -1,
  ArrowDown: -1,
  PageUp: 10,
  PageDown: -10,
}

/** The value that a key of a slider leads to; undefined for any other key. */
export function stepped(
  { key, shiftKey }: Pick<KeyboardEvent, 'key' | 'shiftKey'>,
  { from, to, step }: NumberControl,
  value: number,
): number | undefined {
  if (key === 'Home') return from
  if (key === 'End') return to
  const steps = moves[key]
  return steps === undefined ? undefined : value + steps * step * (shiftKey ? 10 : 1)
}
