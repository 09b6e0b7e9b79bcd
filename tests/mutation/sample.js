import { readFileSync, readdirSync } from 'node:fs'
import { join } from 'node:path'
import ts from 'typescript'

/**
 * The functions of a folder's files, by their first and last lines: functions, methods, and what else stands at the top of a
 * file or in a class and does something. In the order of the files' names.
 */
export function functionsOf(folder) {
  return readdirSync(folder, { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.ts'))
    .sort()
    .flatMap((file) => {
      const source = ts.createSourceFile(
        file,
        readFileSync(join(folder, file), 'utf8'),
        ts.ScriptTarget.Latest,
      )
      const lineAt = (position) => source.getLineAndCharacterOfPosition(position).line + 1
      return source.statements
        .flatMap((statement) =>
          ts.isClassDeclaration(statement) ? [...statement.members] : [statement],
        )
        .filter((node) => !isOnlyTypes(node))
        .map((node) => ({ file, from: lineAt(node.getStart(source)), to: lineAt(node.end) }))
    })
}

function isOnlyTypes(node) {
  return (
    ts.isImportDeclaration(node) ||
    ts.isExportDeclaration(node) ||
    ts.isInterfaceDeclaration(node) ||
    ts.isTypeAliasDeclaration(node) ||
    (ts.isPropertyDeclaration(node) && !node.initializer)
  )
}
