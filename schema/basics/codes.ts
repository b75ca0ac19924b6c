import type { ProblemCode } from './adjustable.ts';
import { OBJECT_KINDS } from './kinds.ts';

/** The explanation of a code, as `gq explain CODE` prints it. */
export interface CodeExplanation {
  /** The stable name of the kind of problem. */
  readonly code: string;
  /** Whether it keeps a file from being used. */
  readonly severity: 'error' | 'warning';
  /** What the problem is, in one line. */
  readonly title: string;
  /** Why it matters. */
  readonly why: string;
  /** How to fix it. */
  readonly fix: string;
  /** An excerpt of a file before and after the fix. */
  readonly example?: string;
}

interface Explanation {
  readonly title: string;
  readonly why: string;
  readonly fix: string;
  readonly example?: string;
}

const EXPLANATIONS: Readonly<Record<ProblemCode, Explanation>> = {
  'file-too-large': {
    title: 'the file is larger than 8 MiB',
    why: 'A level of 100 objects takes about 6 kB. A file this large holds something else, and reading it would only cost time and memory.',
    fix: 'Check that the path names a level file.',
  },
  'empty-file': {
    title: 'the file is empty',
    why: 'A save that was cut short can leave an empty file. There is nothing in it to check.',
    fix: 'Write a level into it, or delete it.',
    example: '{ "version": 1, "name": "First swing", "astronaut": { "x": 0, "y": 0 }, "blackHole": { "x": 0, "y": 200 } }',
  },
  'not-a-level': {
    title: 'the file is a picture, an archive or another kind of file',
    why: 'Its first bytes are those of another kind of file. Whatever the file is called, it holds no level that could be read.',
    fix: 'Choose the level file: a JSON text that begins with `{`. Unpack an archive first.',
  },
  'pointer-file': {
    title: 'the file only says where its content is',
    why: 'Git LFS and git-annex keep large files elsewhere, and leave a short text in their place until the content is fetched. Where symbolic links are off, git writes the path of a link as a text. Either way, the level is not here.',
    fix: 'Fetch the content: `git lfs install` and `git lfs pull`, or `git annex get` with the path. In CI, check out with LFS (`lfs: true` of actions/checkout). In place of a link, copy the file. Levels are small: they need no LFS.',
  },
  'not-utf8': {
    title: 'the file is not UTF-8 text',
    why: 'Level files are UTF-8. The bytes of another encoding would be read as different letters on different machines.',
    fix: 'Save the file as UTF-8 in your editor (not Latin-1, Windows-1252 or UTF-16).',
  },
  'byte-order-mark': {
    title: 'the file begins with a byte order mark',
    why: 'Level files have one canonical layout. The three invisible bytes EF BB BF break strict JSON readers and show up as a change in git.',
    fix: 'Save the file as "UTF-8", not "UTF-8 with BOM"; `gq fmt` removes the mark.',
  },
  'invalid-json': {
    title: 'the text is not valid JSON',
    why: 'A level whose text cannot be read cannot be checked. Only the first error of this kind is reported, because everything after it depends on it.',
    fix: 'Correct the marked place. Put texts and keys in double quotes and commas between entries.',
    example: '{ "x": 712, "y": 600 }',
  },
  'truncated-json': {
    title: 'the text ends too early',
    why: 'A bracket or a text is still open at the end of the file. The rest is missing, as after a save that was cut short or a bad merge.',
    fix: 'Add what is missing, or take the file from git again.',
  },
  'too-deep': {
    title: 'brackets are nested too deeply',
    why: 'A level needs 4 levels of brackets. More than 64 is a mistake or an attack, and some JSON readers crash on it.',
    fix: 'Remove the extra brackets.',
  },
  'duplicate-key': {
    title: 'an object has the same key twice',
    why: 'JSON readers silently keep one of the two values, and not all of them keep the same one: two tools would see two different levels.',
    fix: 'Keep one of the two.',
    example: '{ "x": 1, "x": 2 }  ->  { "x": 2 }',
  },
  'not-a-number': {
    title: 'NaN or Infinity stands where a number should',
    why: 'JSON has no such values, and no coordinate or size in a level can be one. The program that wrote the file has computed nonsense.',
    fix: 'Write a number.',
  },
  'number-too-large': {
    title: 'a number is too large for a double',
    why: 'It would be read as Infinity, and every distance to it would be infinite or not a number.',
    fix: 'Write a number that a double can hold (at most 1.79e308) and that is within the limits of its key.',
    example: '1e999',
  },
  comment: {
    title: 'the file contains a comment',
    why: 'JSON has no comments, and a comment would be lost when the file is formatted.',
    fix: 'Move the text into a key: "description", or one of your own that begins with x-.',
    example: '"x-note": "the narrow gap is meant"',
  },
  'trailing-comma': {
    title: 'a comma stands before a closing bracket',
    why: 'JSON does not allow this, and some readers count an empty entry there.',
    fix: 'Remove the comma.',
    example: '[1, 2,]  ->  [1, 2]',
  },
  'wrong-quotes': {
    title: 'a text is in the wrong quotes',
    why: 'JSON has only the straight double quote ". Single quotes, backticks and typographic quotes do not quote anything.',
    fix: 'Use double quotes.',
    example: '\'name\'  ->  "name"',
  },
  'missing-version': {
    title: 'the file does not say which version of the format it uses',
    why: 'The version says how to read the rest of the file, now and after the format changes.',
    fix: 'Add "version": 1 as the first key.',
  },
  'newer-version': {
    title: 'the file uses a newer version of the format',
    why: 'A newer toolkit wrote the file. This one could misread it, so it refuses it.',
    fix: 'Update the toolkit.',
  },
  'unsupported-version': {
    title: 'the version is not one that this toolkit can read',
    why: 'The version is a whole number, 1 or greater. For any other value nothing says how to read the rest.',
    fix: 'Write "version": 1 if the file follows the current format.',
  },
  'unknown-key': {
    title: 'an object has a key that the format does not know',
    why: 'If a misspelt key were ignored, the level would silently lack what the key says. So every unknown key is an error.',
    fix: 'Correct the spelling or remove the key. Keys of your own begin with x-: they are kept but not checked.',
    example: '"asteriods"  ->  "asteroids"',
  },
  'missing-key': {
    title: 'an object lacks a key that it must have',
    why: 'The key has no sensible default.',
    fix: 'Add the key.',
  },
  'wrong-type': {
    title: 'a value is of the wrong type',
    why: 'Nothing is converted silently: a number in quotes, or a list in place of an object, is a mistake of the program that wrote the file.',
    fix: 'Write a value of the expected type.',
    example: '"x": "712"  ->  "x": 712',
  },
  'out-of-limits': {
    title: 'a number is outside its limits',
    why: 'A radius below 0.001 px has no meaning (recoil is proportional to 1 / diameter), and numbers far beyond any level cost accuracy. Coordinates go up to 1e9 px, radii and the range from 0.001 to 1e6 px, speeds up to 1000 px/s per axis, ticks up to 216000 (an hour).',
    fix: 'Write a number within the limits.',
  },
  'not-whole': {
    title: 'a tick is not a whole number',
    why: 'The gun is pressed and released at ticks of 1/60 s, counted from 0.',
    fix: 'Round it to the nearest tick.',
    example: '[12.5, 96]  ->  [12, 96]',
  },
  'too-many': {
    title: 'a list is too long',
    why: 'A list of objects or of holds has at most 20,000 entries, a list of runs at most 1,000. A longer list comes from a program that went wrong.',
    fix: 'Remove entries, or split the level.',
  },
  'empty-text': {
    title: 'a name is empty',
    why: 'Reports, pictures and the editor show levels and runs by their names.',
    fix: 'Give it a name.',
  },
  'text-too-long': {
    title: 'a text is too long',
    why: 'A name must fit on one line of a report: at most 120 characters for a level and 80 for a run. A description has at most 2000, the reason for an allowed problem 300.',
    fix: 'Shorten it.',
  },
  'bad-id': {
    title: 'an id has a wrong length or wrong characters',
    why: 'An id has 2 to 16 of the characters a-z and 0-9, so that it never needs quoting.',
    fix: 'Remove the id: `gq fmt` writes a new one.',
    example: '"id": "Rock 1"  ->  "id": "k3x9qa"',
  },
  'duplicate-id': {
    title: 'two objects have the same id',
    why: 'Ids tell objects apart when a level is edited, compared or merged. Copying an object by hand copies its id as well.',
    fix: 'Remove one of the two ids: `gq fmt` writes a new one.',
  },
  'duplicate-run-name': {
    title: 'two runs have the same name',
    why: 'Commands choose a run by its name (`gq simulate --run NAME`).',
    fix: 'Rename one of the two.',
  },
  'reversed-hold': {
    title: 'a hold ends before it begins, or in the same tick',
    why: 'A hold is [press, release): the gun is held from the tick of the press up to, but not including, the tick of the release. If the release does not come after the press, the gun is never held.',
    fix: 'Swap the two ticks, or remove the hold.',
    example: '[96, 12]  ->  [12, 96]',
  },
  'merge-markers': {
    title: 'git could not merge the file, and its markers are still there',
    why: 'Between <<<<<<< and >>>>>>> the file has both versions of some lines, one after the other, with ======= between them. That is no JSON, and nobody has decided yet which version is right.',
    fix: 'Keep one version of the lines and delete the markers; or take the whole file of one side with `git checkout --ours` or `git checkout --theirs` and its path. Then `git add` it. After `gq git-setup`, git merges levels by object, and a level with a conflict can still be opened.',
    example: '<<<<<<< HEAD\n"range": 200,\n=======\n"range": 300,\n>>>>>>> other  ->  "range": 300,',
  },
  'merge-conflict': {
    title: 'a merge left something undecided',
    why: 'Two versions of the level changed the same property in different ways. The level holds our value, and "conflicts" lists both, so nothing is lost; but nobody has decided yet which of them is right.',
    fix: 'Open the level with `gq edit` and choose a side for each conflict. Or edit the file: correct the value in place where theirs is right, and delete the entry of "conflicts"; delete the key once its list is empty.',
    example:
      '"conflicts": [\n  {\n    "what": "asteroid k3x9qa, radius",\n    "key": "asteroids/k3x9qa/radius",\n    "base": 16,\n    "ours": 20,\n    "theirs": 24\n  }\n]',
  },
  'one-per-level': {
    title: 'a list stands where a level has exactly one object',
    why: 'A level has one astronaut and one black hole.',
    fix: 'Keep one of them, without the list around it.',
    example: '"astronaut": [{ "x": 0, "y": 0 }]  ->  "astronaut": { "x": 0, "y": 0 }',
  },
  'nothing-to-import': {
    title: 'there is no level in the file',
    why: 'Empty objects are placeholders of the original game and are skipped. The file holds nothing else.',
    fix: 'Check that it is the file with the level objects: a list of objects with "player" and "target", or one of them.',
  },
  'not-in-original': {
    title: 'the original game does not have what the level has',
    why: 'The level objects of the original game have no words for it, and without it the level plays differently: runs that complete it here may fail there.',
    fix: 'Remove it from the level and check the runs again. `gq export --drop` leaves it out of the exported file.',
  },
  'unknown-class': {
    title: 'an object of a Tiled map has no class that is a kind of object',
    why: 'The class says what the object is in the level. An object that was left out without a word would be missing in the level.',
    fix: `Set its Class in Tiled to one of ${OBJECT_KINDS.join(', ')}, or name its layer after the kind.`,
  },
  'wrong-shape': {
    title: 'an object of a Tiled map is not drawn as a circle or a point',
    why: 'Everything in a level is a circle, but for the astronaut, who has a place. An ellipse, a polygon or a tile would become another shape than the one that was drawn.',
    fix: 'Draw circles with Insert Ellipse while Shift is held, the astronaut and minerals with Insert Point, and leave the rotation at 0.',
  },
  'unpaired-mouth': {
    title: 'a mouth in a Tiled map leads nowhere',
    why: 'Objects with two places are two circles in a map, and a property of one of them names the other.',
    fix: 'Give one of the two a property `to` of type object, and choose the other one.',
  },
  'unsupported-map': {
    title: 'the Tiled map is of a kind that cannot be read',
    why: 'Places in an isometric or hexagonal map are not the places that are seen, and a text that is not valid XML has no places at all.',
    fix: 'Save an orthogonal map with Tiled, as .tmj or .tmx.',
  },
  'unknown-code': {
    title: 'no problem has this code',
    why: 'A misspelt code would silently change nothing, and the problem that is meant would still be reported.',
    fix: 'Correct the spelling: `gq explain` lists all codes.',
    example: '"allow": { "unused-astroid": "a landmark" }  ->  "allow": { "unused-asteroid": "a landmark" }',
  },
  'fixed-severity': {
    title: 'this problem cannot be allowed, lowered or switched off here',
    why: 'Some problems are always errors: a file with one is no level, or nothing shows that the level can be completed. No configuration makes such a level green. Others are not about one level, so a level cannot allow them.',
    fix: 'Remove the line and fix the problem, or leave the file out with "ignore" in gq.config.json.',
    example: '"allow": { "no-run": "still a draft" }  ->  "ignore": ["drafts"]',
  },
  'unknown-value': {
    title: 'a text is none of those that are known here',
    why: 'A misspelt name of a severity, an accuracy or a reporter would otherwise be ignored, and the check would not be the one that is meant.',
    fix: 'Write one of the names that the message lists.',
    example: '"accuracy": "exact"  ->  "accuracy": "precise"',
  },
  'empty-list': {
    title: 'a list of the configuration is empty',
    why: 'Nothing checked is never green, so an empty list of levels or reports is a mistake.',
    fix: 'Add an entry, or remove the key: then the default applies.',
  },
  'more-problems': {
    title: 'there are more problems than are shown',
    why: 'After 20 problems the rest are only counted, because many of them tend to have the same cause.',
    fix: 'Fix those that are shown, and check again.',
  },
};

/** Explanations of the codes of all problems that reading or importing a file can give. */
export const CODES: readonly CodeExplanation[] = Object.entries(EXPLANATIONS).map(([code, explanation]) => ({
  code,
  severity: 'error',
  ...explanation,
}));
