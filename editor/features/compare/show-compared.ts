import type { Editor, OpenLevel } from '../../core/context/index.ts';
import { keepAsRun } from '../../core/levels/index.ts';
import { comparedOf, MOST_COMPARED, type Source, sourceName, toggleCompared } from './compared.ts';

/** Puts a run beside the shown one or takes it away; says why if there is no room. */
export function compareOrTell({ notices }: Pick<Editor, 'notices'>, level: OpenLevel, source: Source): void {
  if (source.kind === 'run' && source.name === level.proof.proof().run.name) {
    notices.show('info', `${source.name} is the shown run: compare it with another one.`, { topic: 'compare' });
    return;
  }
  if (toggleCompared(comparedOf(level), source)) {
    notices.clear('compare');
    return;
  }
  const text = `${MOST_COMPARED} runs are compared already. Stop comparing one of them, then add ${sourceName(source)}.`;
  notices.show('warning', text, { topic: 'compare' });
}

/** Makes a compared run the shown one; they change places. An attempt has to become a run first. */
export function showCompared(editor: Editor, level: OpenLevel, source: Source): void {
  if (source.kind === 'run') {
    editor.session.setState({ run: source.name });
    return;
  }
  const attempt = level.attempts.store.getState().find(({ number }) => number === source.number);
  if (attempt === undefined) return;
  const text = `${sourceName(source)} is not a run of the level. Keep it as one to show and edit it.`;
  const keep = () => keepAsRun({ editor, level }, attempt);
  editor.notices.show('info', text, { topic: 'compare', actions: [{ title: 'Keep as a run', run: keep }] });
}
