import { RotateCcw } from 'lucide-react';
import { useEffect, useRef } from 'react';
import type { LevelFile } from '../../../schema/index.ts';
import { useEditor, useFolderTerms, useSession } from '../../core/context/index.ts';
import { problemsInWords } from '../../core/files/index.ts';
import { Section } from '../../core/panel/index.ts';
import { Button } from '../../core/ui/index.ts';
import { RuleRow } from './RuleRow.tsx';
import { ruleValues } from './rule-values.ts';

/** The rules of the level: its own, those of its folder, and the game's defaults. */
export function RuleFields({ file }: { readonly file: LevelFile }) {
  const { commands, session } = useEditor();
  const folder = useFolderTerms();
  const rules = ruleValues(file, folder);
  const asked = useSession((state) => state.askedRule);
  const list = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (asked === null) return;
    session.setState({ askedRule: null });
    const row = list.current?.querySelector(`[data-rule="${asked}"]`);
    row?.scrollIntoView({ block: 'center' });
    row?.querySelector<HTMLInputElement>('input[type="range"]')?.focus({ preventScroll: true });
  }, [asked, session]);
  useEffect(() => {
    const panel = list.current?.closest('.panel__body');
    if (panel == null) return;
    // A rule that breaks the run opens the list of problems, which must not cover the focused slider.
    const observer = new ResizeObserver(() => {
      const { activeElement } = panel.ownerDocument;
      if (list.current?.contains(activeElement)) activeElement?.closest('.rule')?.scrollIntoView({ block: 'nearest' });
    });
    observer.observe(panel);
    return () => observer.disconnect();
  }, []);
  const areSome = rules.some(({ isOwn }) => isOwn);
  return (
    <Section
      title="Rules"
      aside={
        areSome && (
          <Button
            hint={`Reset to ${folder.file === null ? "the game's defaults" : `the rules of ${folder.file} and the game's defaults`}`}
            icon={<RotateCcw size={13} />}
            onClick={() => commands.run('rules.reset')}
          >
            Reset all
          </Button>
        )
      }
    >
      {folder.problems.length > 0 && (
        <p className="tone--bad">
          {problemsInWords(folder.file ?? 'gq.config.json', folder.problems)} Its previous rules stay in effect until it is fixed.
        </p>
      )}
      <div ref={list} className="rules">
        {rules.map((rule) => (
          <RuleRow key={rule.name} {...rule} />
        ))}
      </div>
    </Section>
  );
}
