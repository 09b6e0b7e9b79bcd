type Values = Readonly<Record<string, unknown>>

/**
 * Parameters with some of them set anew. Static friction is never below kinetic: where one of the two is set, the other
 * follows it. Both set are left to the check, as is anything but a number.
 */
export function withParameters<P extends Values, V extends Values>(parameters: P, set: V): P & V {
  const all: P & V = { ...parameters, ...set }
  const { muStatic, muKinetic } = all
  if (typeof muStatic !== 'number' || typeof muKinetic !== 'number' || muStatic >= muKinetic)
    return all
  const [setsStatic, setsKinetic] = ['muStatic' in set, 'muKinetic' in set]
  if (setsStatic === setsKinetic) return all
  return setsStatic ? { ...all, muKinetic: muStatic } : { ...all, muStatic: muKinetic }
}
