// Before the report's page.js, which sets the words that it finds.
import words from './page-words.js';

const data = document.getElementById('data');
data.textContent = JSON.stringify({ words });
