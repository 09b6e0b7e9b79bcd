import { nothing } from 'lit'
import type { LabView } from './labView.ts'

/** A part of a lab, unless a lesson takes its control from readers. */
export function allowed<Part>({ lesson }: Pick<LabView, 'lesson'>, control: string, part: Part) {
  return lesson && !lesson.may(control) ? nothing : part
}
