import type { CheckReport, Problem } from '../../schema/index.ts';

/** A problem as in every JSON report. */
export function problemJson({
  code,
  severity,
  message,
  line,
  column,
  pointer,
}: Problem): CheckReport['levels'][number]['problems'][number] {
  return { code, severity, message, line, column, pointer };
}
