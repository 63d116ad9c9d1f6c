// Writes the grammar anew from the program's table of words: npm run grammar (VERISIM names the program).
import { execFileSync } from 'node:child_process';
import { writeFileSync } from 'node:fs';

writeFileSync(new URL('../syntaxes/pov.tmLanguage.json', import.meta.url),
  execFileSync(process.env.VERISIM ?? 'verisim', ['help', '--format', 'grammar']));
