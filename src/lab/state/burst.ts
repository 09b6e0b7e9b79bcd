import type { Change } from './state.ts'

/**
 * The name of what a change may be part of: the dragging of a handle or a slider, the stepping of a number. Choices
 * stand for themselves.
 */
export function burstOf(change: Change): string | undefined {
  switch (change.kind) {
    case 'parameters':
      return Object.keys(change.values).join(' ')
    case 'duration':
      return 'duration'
    case 'option':
      return `${change.index} ${change.of} ${change.key}`
    default:
      return undefined
  }
}
